#include "tests/core/pipeline/CarScans.h"

#include <cmath>

#include "core/base/AtomicFile.h"
#include "core/base/Csv.h"
#include "core/base/Numbers.h"
#include "core/base/Random.h"
#include "core/base/Units.h"
#include "core/geometry/PointCloudBuilder.h"
#include "tests/core/registration/StreetScene.h"

namespace vestige::test {
namespace {

/// Points on what lies round the car: the road and some boxes on it, one per `spacing`.
void addRoad(PointCloudBuilder& builder, Random& random, const Similarity& toFile, double spacing,
             double noise_m, double fromX) {
    const auto patch = [&](const Eigen::Vector3d& corner, const Eigen::Vector3d& u,
                           const Eigen::Vector3d& v) {
        const Eigen::Vector3d normal = u.cross(v).normalized();
        const int count = static_cast<int>(u.norm() * v.norm() / (spacing * spacing));
        for (int i = 0; i < count; ++i) {
            const Eigen::Vector3d x =
                corner + random.uniform() * u + random.uniform() * v + random.normal(0, noise_m) * normal;
            if (x.x() > fromX) builder.add(toFile * x);
        }
    };
    patch({-6, -5, 0}, {12, 0, 0}, {0, 10, 0});
    const auto box = [&](double x, double y, double turn, double length, double width, double height) {
        const Eigen::AngleAxisd yaw(turn, Eigen::Vector3d::UnitZ());
        const Eigen::Vector3d at(x, y, 0), u = yaw * Eigen::Vector3d(length, 0, 0),
                                           v = yaw * Eigen::Vector3d(0, width, 0), w(0, 0, height);
        patch(at + w, u, v);
        patch(at, u, w);
        patch(at, v, w);
        patch(at + u, v, w);
        patch(at + v, u, w);
    };
    box(3.0, 0.6, 0.4, 0.5, 0.3, 0.4);
    box(2.0, -2.2, 1.1, 0.6, 0.4, 0.5);
    box(0.2, 1.6, -0.3, 0.4, 0.4, 0.6);
    box(-1.6, -1.9, 0.2, 0.5, 0.5, 0.3);
    box(-3.2, 0.9, 0.8, 0.4, 0.6, 0.5);
    box(-3.0, -1.0, -0.5, 0.3, 0.3, 0.7);
    box(4.6, -3.0, 0.9, 0.9, 0.5, 1.1);
    box(-5.0, 3.2, 0.3, 1.2, 0.6, 0.9);
}

bool inSector(const Eigen::Vector3d& x, double azimuth_deg) {
    if (std::abs(x.x()) > 3.9 || std::abs(x.y()) > 2.6) return false;
    double off = degrees(std::atan2(x.y() / 0.9, x.x() / 2.25)) - azimuth_deg;
    off -= 360 * std::round(off / 360);
    return std::abs(off) < 80;
}

Layer layerOf(const std::string& id, LayerRole role, LengthUnit unit, PointCloud cloud) {
    Layer layer;
    layer.id = layer.name = id;
    layer.role = role;
    layer.method = "lidar";
    layer.unit = unit;
    auto geometry = std::make_shared<const TriangleMesh>(TriangleMesh{std::move(cloud), {}});
    auto data = std::make_shared<LayerData>();
    data->geometry = geometry;
    data->points = {geometry, &geometry->vertices};
    layer.data = std::move(data);
    return layer;
}

}  // namespace

CarScans::CarScans(const std::filesystem::path& folder, std::uint64_t seed) : folder_(folder), seed_(seed) {
    const auto check = [](const Status& set) {
        if (!set) throw std::runtime_error(set.error().sentence());
    };
    check(scene.preprocess.setFromText("filter", "none"));
    check(scene.registration.setFromText("voxel_m", "0.2"));
    check(scene.registration.setFromText("restarts", "0"));
}

Layer& CarScans::addAerial(const std::string& id, double noise_m, double fromX, const Pose& off) {
    const Similarity world{Pose(Eigen::Translation3d(origin())) * off, 1};
    PointCloudBuilder builder(origin());
    Random random(++seed_);
    addRoad(builder, random, world, 0.05, noise_m, fromX);
    const PointCloud car = carSurface(1200, noise_m, ++seed_);
    for (std::size_t i = 0; i < car.size(); ++i)
        if (const Eigen::Vector3d x = car.point(i); x.x() > fromX && x.z() > 0.4) builder.add(world * x);
    truth_[id] = {
        Pose(Eigen::Translation3d(origin())) * off.inverse() * Pose(Eigen::Translation3d(-origin())), 1};
    scene.layers.push_back(layerOf(id, LayerRole::aerial, LengthUnit::metre, std::move(builder).build()));
    if (scene.target.empty()) scene.target = id;
    return scene.layers.back();
}

Layer& CarScans::addScan(const std::string& id, double azimuth_deg, const std::string& to) {
    Random random(++seed_);
    Similarity truth{Pose::Identity(), 0.001};
    truth.pose.linear() =
        Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), random.normal())
            .normalized()
            .toRotationMatrix();
    truth.pose.translation() = origin() + Eigen::Vector3d(random.normal(), random.normal(), random.normal());
    const Similarity fileFromCar = truth.inverse() * Similarity{Pose(Eigen::Translation3d(origin())), 1};

    PointCloudBuilder all(Eigen::Vector3d::Zero());
    const PointCloud car = carSurface(6000, 0.0005, ++seed_);
    for (std::size_t i = 0; i < car.size(); ++i) all.add(car.point(i));
    addRoad(all, random, {}, 0.02, 0.0005, -100);
    const PointCloud seen = std::move(all).build();
    PointCloudBuilder builder(Eigen::Vector3d::Zero());
    for (std::size_t i = 0; i < seen.size(); ++i)
        if (const Eigen::Vector3d x = seen.point(i); inSector(x, azimuth_deg)) builder.add(fileFromCar * x);

    scene.layers.push_back(
        layerOf(id, LayerRole::handheld, LengthUnit::millimetre, std::move(builder).build()));
    Layer& layer = scene.layers.back();
    truth_[id] = truth;
    const Similarity toFromFile = to.empty() ? truth : this->truth(to).inverse() * truth;
    std::string csv = csvLine({"tx", "ty", "tz", "sx", "sy", "sz"});
    for (int pick = 0; pick < 5; ++pick) {
        const PointCloud& points = *layer.data->points;
        const Eigen::Vector3d source = points.point(random.below(points.size()));
        const Eigen::Vector3d off(random.normal(0, 20), random.normal(0, 20), random.normal(0, 20));
        const Eigen::Vector3d target = toFromFile * (source + off);
        std::vector<std::string> cells;
        for (const Eigen::Vector3d& end : {target, source})
            for (const double c : end) cells.push_back(exactText(c));
        csv += csvLine(cells);
    }
    const std::filesystem::path file = folder_ / (id + "_picks.csv");
    if (const Status written = writeTextFile(file, csv); !written)
        throw std::runtime_error(written.error().sentence());
    layer.init = InitPicks{file, to};
    return layer;
}

double CarScans::error(const std::string& id, const Similarity& found) const {
    const PointCloud& points = *scene.layer(id)->data->points;
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); i += 50)
        sum += (found * points.point(i) - truth(id) * points.point(i)).squaredNorm();
    return std::sqrt(50 * sum / static_cast<double>(points.size()));
}

}  // namespace vestige::test
