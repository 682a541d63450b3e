#include "tests/core/pipeline/TinyCase.h"

#include "core/base/AtomicFile.h"
#include "core/base/Csv.h"
#include "core/base/Numbers.h"
#include "core/base/Random.h"
#include "core/base/Units.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/io/FormatRegistry.h"

namespace vestige::test {
namespace {

constexpr double kLength = 4.4;  // of the box, y

/// Points on a rectangle from `corner` along u and v, jittered, with noise along the normal.
void addPanel(PointCloudBuilder& builder, Random& random, const Similarity& toFile,
              const Eigen::Vector3d& corner, const Eigen::Vector3d& u, const Eigen::Vector3d& v,
              double spacing, double noise) {
    const Eigen::Vector3d normal = u.cross(v).normalized();
    const int countU = static_cast<int>(u.norm() / spacing);
    const int countV = static_cast<int>(v.norm() / spacing);
    for (int i = 0; i <= countU; ++i)
        for (int j = 0; j <= countV; ++j)
            builder.add(toFile * (corner + u * (static_cast<double>(i) / countU) +
                                  v * (static_cast<double>(j) / countV) + normal * random.normal(0, noise)));
}

/// The box's top and sides, the front (towards -y) and what stands round it; `front`: what the handheld sees.
void addScene(PointCloudBuilder& builder, Random& random, const Similarity& toFile, bool front,
              double spacing, double noise) {
    using Eigen::Vector3d;
    const auto panel = [&](const Vector3d& corner, const Vector3d& u, const Vector3d& v) {
        addPanel(builder, random, toFile, corner, u, v, spacing, noise);
    };
    const double w = TinyCase::kWidth;
    const double h = TinyCase::kHeight;
    panel({0, 0, h}, {w, 0, 0}, {0, front ? 1.2 : kLength, 0});
    panel({0, 0, 0}, {0, front ? 1.2 : kLength, 0}, {0, 0, h});
    panel({w, 0, 0}, {0, front ? 1.2 : kLength, 0}, {0, 0, h});
    panel({0, 0, 0}, {w, 0, 0}, {0, 0, h});
    panel({front ? -0.5 : -5, front ? -1.5 : -6, 0}, {front ? 2.8 : 11, 0, 0}, {0, front ? 1.4 : 6, 0});
    panel({-0.4, -0.8, 0}, {0.3, 0, 0}, {0, 0, 0.9});
    panel({1.9, -1.0, 0}, {0, 0.3, 0}, {0, 0, 0.7});
    if (front) return;
    panel({0, kLength, 0}, {w, 0, 0}, {0, 0, h});
    panel({-5, 0, 0}, {5, 0, 0}, {0, 7, 0});
    panel({w, 0, 0}, {4, 0, 0}, {0, 7, 0});
}

Layer layer(const std::string& id, LayerRole role, const std::filesystem::path& path, LengthUnit unit) {
    Layer layer;
    layer.id = layer.name = id;
    layer.role = role;
    layer.method = "lidar";
    layer.path = path;
    layer.unit = unit;
    return layer;
}

void write(const std::filesystem::path& file, PointCloudBuilder builder) {
    const Status written = writeGeometry(file, TriangleMesh{std::move(builder).build(), {}});
    if (!written) throw std::runtime_error(written.error().sentence());
}

/// Four pairs, a centimetre off.
void writePicks(const std::filesystem::path& file, const Similarity& targetFromSource, Random& random) {
    std::string csv = csvLine({"tx", "ty", "tz", "sx", "sy", "sz"});
    const double w = TinyCase::kWidth;
    const double h = TinyCase::kHeight;
    for (const Eigen::Vector3d& corner : {Eigen::Vector3d(0, 0, h), Eigen::Vector3d(w, 0, h),
                                          Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(w, 1.1, h)}) {
        const Eigen::Vector3d target = TinyCase::origin() + corner;
        Eigen::Vector3d source = targetFromSource.inverse() * target;
        for (double& c : source) c += random.normal(0, 10);
        std::vector<std::string> cells;
        for (const double c : target) cells.push_back(exactText(c));
        for (const double c : source) cells.push_back(exactText(c));
        csv += csvLine(cells);
    }
    if (const Status written = writeTextFile(file, csv); !written)
        throw std::runtime_error(written.error().sentence());
}

/// The length of the box by picks, or a metre of its front by aims.
Measurement measured(bool aimed) {
    Measurement measurement;
    measurement.object = aimed ? "Width of the front" : "Length of the box";
    measurement.tape_m = aimed ? 1.0 : kLength;
    if (aimed) {
        // Left and right upper edge of the front, where the named view shows them, off by some pixels.
        for (const double off : {0.0, 1.0, -2.0})
            measurement.aims["lidar"].push_back(
                {{"front", {100.5 + off, 100.5}, {"front"}}, {"front", {300.5 - off, 100.5}, {"front"}}});
        return measurement;
    }
    for (const double off : {0.0, 0.01, -0.02}) {
        const Eigen::Vector3d a = TinyCase::origin() + Eigen::Vector3d(0.9, 0, 1.4);
        const Eigen::Vector3d b = TinyCase::origin() + Eigen::Vector3d(0.9, kLength + off, 1.4);
        measurement.picks["aerial"].push_back({{"aerial", a, {}, false}, {"aerial", b, {}, false}});
    }
    return measurement;
}

/// Square to the front, 5 mm to a pixel: its upper corners lie at (20, 20) and (380, 20) and the columns 100
/// and 300 are 1 m apart.
ViewCamera frontView() {
    ViewCamera camera;
    camera.parallel = true;
    camera.width_px = 400;
    camera.height_px = 300;
    camera.halfHeight_m = 0.75;
    const Eigen::Vector3d middle = TinyCase::origin() + Eigen::Vector3d(0.9, 0, 0.75);
    camera.focalPoint = middle;
    camera.position = middle - Eigen::Vector3d(0, 5, 0);
    camera.viewUp = Eigen::Vector3d::UnitZ();
    return camera;
}

}  // namespace

TinyCase::TinyCase(const std::filesystem::path& folder, bool withHandheld) {
    Random random(7);
    truth.scale = 0.001;
    truth.pose.linear() = (Eigen::AngleAxisd(radians(140), Eigen::Vector3d::UnitZ()) *
                           Eigen::AngleAxisd(radians(25), Eigen::Vector3d::UnitX()))
                              .toRotationMatrix();
    truth.pose.translation() = origin() + Eigen::Vector3d(0.4, -0.2, 0.6);
    const Similarity world{Pose(Eigen::Translation3d(origin())), 1};

    scene.name = "Tiny case";
    scene.target = "aerial";
    PointCloudBuilder aerial(origin());
    addScene(aerial, random, world, false, 0.06, 0.004);
    write(folder / "aerial.ply", std::move(aerial));
    scene.layers.push_back(layer("aerial", LayerRole::aerial, folder / "aerial.ply", LengthUnit::metre));
    if (withHandheld) {
        PointCloudBuilder front(Eigen::Vector3d::Zero());
        addScene(front, random, truth.inverse() * world, true, 0.02, 0.0002);
        write(folder / "front.ply", std::move(front));
        writePicks(folder / "front_picks.csv", truth, random);
        scene.layers.push_back(
            layer("front", LayerRole::handheld, folder / "front.ply", LengthUnit::millimetre));
        scene.layers.back().init = InitPicks{folder / "front_picks.csv"};
    }
    scene.preprocess = ParameterSet(scene.preprocess.table());
    if (const Status set = scene.preprocess.setFromText("filter", "none"); !set)
        throw std::runtime_error(set.error().sentence());
    scene.views["front"] = frontView();
    scene.measurements = {measured(false), measured(true)};
}

Status NotingRenderer::renderPng(const ViewDescription& view, const std::filesystem::path& png,
                                 const JobControl&) {
    drawn.push_back(view);
    std::string text = view.title;
    for (const auto& layer : view.layers)
        text += "\n" + layer.id + " " + std::to_string(layer.geometry->vertices.size());
    return writeTextFile(png, text);
}

Status NotingPrinter::printPdf(const Report& report, const std::filesystem::path& pdf, const JobControl&) {
    printed = report;
    return writeTextFile(pdf, report.title);
}

}  // namespace vestige::test
