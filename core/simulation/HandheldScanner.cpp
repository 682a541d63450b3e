#include "core/simulation/HandheldScanner.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/Parallel.h"
#include "core/base/Random.h"
#include "core/base/Units.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/simulation/PointThinning.h"

namespace vestige {
namespace {

constexpr std::uint64_t kFrameStream = 200;
constexpr std::uint64_t kRowStreams = std::uint64_t{1} << 40;

/// One row of a shot's raster; the unit of parallel work.
struct Row {
    Eigen::Vector3d from;
    Eigen::Vector3d start;  ///< where the row's first ray aims
    Eigen::Vector3d step;
    Eigen::Vector3d up;  ///< one spacing across the row, for the jitter
    int rays;
};

struct Scanned {
    std::vector<Eigen::Vector3f> truth;
    std::vector<Eigen::Vector3f> measured;
    std::vector<std::uint16_t> part;
};

std::vector<Row> rowsOf(const HandheldSpec& layer, const Pose& siteFromObject) {
    std::vector<Row> rows;
    for (const SweepSpec& sweep : layer.sweeps) {
        for (int shot = 0; shot < sweep.shots; ++shot) {
            const double share = sweep.shots == 1 ? 0 : static_cast<double>(shot) / (sweep.shots - 1);
            const Eigen::Vector3d from =
                siteFromObject * (sweep.fromStart + share * (sweep.fromEnd - sweep.fromStart));
            const Eigen::Vector3d at =
                siteFromObject * (sweep.atStart + share * (sweep.atEnd - sweep.atStart));
            const Eigen::Vector3d forward = (at - from).normalized();
            const Eigen::Vector3d any =
                std::abs(forward.z()) < 0.95 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitX();
            const Eigen::Vector3d right = forward.cross(any).normalized();
            const Eigen::Vector3d up = right.cross(forward);
            const int columns = static_cast<int>(std::lround(sweep.width_m / layer.spacing_m));
            const int lines = static_cast<int>(std::lround(sweep.height_m / layer.spacing_m));
            for (int line = 0; line < lines; ++line) {
                const double height = (line - 0.5 * lines) * layer.spacing_m;
                rows.push_back({from, at - 0.5 * sweep.width_m * right + height * up, layer.spacing_m * right,
                                layer.spacing_m * up, columns});
            }
        }
    }
    return rows;
}

void scanRow(const RayTracer& tracer, const SurfaceModel& surfaces, const HandheldSheet& sheet,
             const Row& row, Random& random, Scanned& found) {
    const float nearest = static_cast<float>(sheet.workingDistance_m - 0.5 * sheet.depthOfField_m);
    const float farthest = static_cast<float>(sheet.workingDistance_m + 0.5 * sheet.depthOfField_m);
    const double leastCosine = std::cos(sheet.steepest_rad);
    const Eigen::Vector3f from = row.from.cast<float>();
    for (int i = 0; i < row.rays; ++i) {
        const Eigen::Vector3d aim =
            row.start + (i + random.uniform()) * row.step + (random.uniform() - 0.5) * row.up;
        const Eigen::Vector3d direction = (aim - row.from).normalized();
        const auto hit = tracer.cast(from, direction.cast<float>(), 0.05F, farthest);
        if (!hit || hit->distance < nearest) continue;
        const Face& face = surfaces.faces[hit->face];
        if (opticsOf(face.material).returns < 0.5) continue;
        if (std::abs(tracer.normal(hit->face).cast<double>().dot(direction)) < leastCosine) continue;
        const double range = static_cast<double>(hit->distance);
        found.truth.push_back((row.from + range * direction).cast<float>());
        found.measured.push_back(
            (row.from + (range + random.normal(0, sheet.noise_m)) * direction).cast<float>());
        found.part.push_back(face.part);
    }
}

/// Any rotation, and an origin some decimetres from the middle of the scan.
Similarity ownFrame(const Scanned& scanned, std::uint64_t seed, std::uint64_t number) {
    Random random(seed, kFrameStream + number);
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3f& point : scanned.truth) middle += point.cast<double>();
    middle /= static_cast<double>(scanned.truth.size());
    Eigen::Quaterniond turn(random.normal(), random.normal(), random.normal(), random.normal());
    Similarity siteFromLayer;
    siteFromLayer.pose.linear() = turn.normalized().toRotationMatrix();
    siteFromLayer.pose.translation() =
        middle +
        Eigen::Vector3d(random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4));
    siteFromLayer.scale = metresPer(LengthUnit::millimetre);
    return siteFromLayer;
}

std::uint64_t streamOf(const std::string& id) {
    std::uint64_t hash = 14695981039346656037ULL;  // FNV-1a
    for (const char letter : id) hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211ULL;
    return hash >> 32;
}

}  // namespace

Result<HandheldScan> scanByHand(const RayTracer& tracer, const SurfaceModel& surfaces,
                                const HandheldSheet& sheet, const HandheldSpec& layer,
                                const Pose& siteFromObject, std::uint64_t seed, const ProbeCounter& probes,
                                const JobControl& control) {
    const std::vector<Row> rows = rowsOf(layer, siteFromObject);
    const std::uint64_t number = streamOf(layer.id);
    constexpr std::size_t kGrain = 16;
    std::vector<Scanned> chunks((rows.size() + kGrain - 1) / kGrain);
    parallelChunks(rows.size(), kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        if (control.cancelled()) return;
        for (std::size_t row = begin; row < end; ++row) {
            Random random(seed, kRowStreams + (number << 20) + row);
            scanRow(tracer, surfaces, sheet, rows[row], random, chunks[chunk]);
        }
    });
    if (control.cancelled()) return fail(cancelledError());
    Scanned all;
    for (Scanned& chunk : chunks) {
        all.truth.insert(all.truth.end(), chunk.truth.begin(), chunk.truth.end());
        all.measured.insert(all.measured.end(), chunk.measured.begin(), chunk.measured.end());
        all.part.insert(all.part.end(), chunk.part.begin(), chunk.part.end());
        chunk = {};
    }
    const std::vector<std::uint32_t> kept = firstPerCell(all.measured, layer.spacing_m);
    if (kept.empty())
        return fail(ErrorCode::input, "the sweeps of this handheld layer meet no surface", layer.id,
                    "surfaces " + std::to_string(sheet.workingDistance_m) + " m from where it stands");
    HandheldScan scan;
    scan.siteFromLayer = ownFrame(all, seed, number);
    scan.probeCounts = probes.zeroes();
    const Similarity layerFromSite = scan.siteFromLayer.inverse();
    PointCloudBuilder builder{Eigen::Vector3d::Zero()};
    builder.reserve(kept.size());
    constexpr std::size_t kSample = 600;
    const std::size_t every = std::max<std::size_t>(1, kept.size() / kSample);
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const std::uint32_t point = kept[i];
        // The file holds single precision; so does the cloud, that both are equal.
        builder.add((layerFromSite * all.measured[point].cast<double>()).cast<float>().cast<double>());
        probes.count(all.truth[point], all.part[point], scan.probeCounts);
        if (i % every == 0) scan.sample.push_back({all.truth[point].cast<double>(), all.part[point]});
    }
    scan.cloud = std::move(builder).build();
    return scan;
}

}  // namespace vestige
