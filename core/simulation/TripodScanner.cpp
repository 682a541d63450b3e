#include "core/simulation/TripodScanner.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "core/base/Parallel.h"
#include "core/base/Random.h"

namespace vestige {
namespace {

constexpr std::uint64_t kRowStreams = 1000;

struct Raster {
    int rows;
    int columns;
};

/// Distance to what answers the ray: glass lets most of it through, mirrors and bare metal lose some.
std::optional<double> echo(const TripodScene& scene, const TripodStation& station,
                           const Eigen::Vector3f& from, const Eigen::Vector3f& direction, Random& random) {
    float nearest = static_cast<float>(station.nearest_m);
    for (int surfaces = 0; surfaces < 8; ++surfaces) {
        const auto hit =
            scene.tracer().cast(from, direction, nearest, static_cast<float>(station.farthest_m));
        if (!hit) return std::nullopt;
        const Optics& optics = opticsOf(scene.surfaces().faces[hit->face].material);
        const double chance = random.uniform();
        if (chance < optics.returns) return static_cast<double>(hit->distance);
        if (chance > optics.returns + optics.passes) return std::nullopt;
        nearest = hit->distance + 1e-4F;
    }
    return std::nullopt;
}

LargeArray<Eigen::Vector3f> scanRaster(const TripodScene& scene, const TripodStation& station,
                                       const Raster& raster) {
    const auto rows = static_cast<std::size_t>(raster.rows);
    const double rowStep = (station.highest_rad - station.lowest_rad) / raster.rows;
    const double columnStep = 2 * std::numbers::pi / raster.columns;
    const Eigen::Vector3f from = station.siteFromScanner.translation().cast<float>();
    constexpr std::size_t kGrain = 4;
    std::vector<std::vector<Eigen::Vector3f>> chunks((rows + kGrain - 1) / kGrain);
    parallelChunks(rows, kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            Random random(station.seed, kRowStreams + row);
            for (int column = 0; column < raster.columns; ++column) {
                const double elevation =
                    station.lowest_rad + (static_cast<double>(row) + random.uniform()) * rowStep;
                const double azimuth = (column + random.uniform()) * columnStep;
                const Eigen::Vector3d direction(std::cos(elevation) * std::cos(azimuth),
                                                std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
                const Eigen::Vector3d inSite = station.siteFromScanner.linear() * direction;
                const auto range = echo(scene, station, from, inSite.cast<float>(), random);
                const double noise = random.normal(0, station.rangeNoise_m);
                if (range) chunks[chunk].push_back(((*range + noise) * direction).cast<float>());
            }
        }
    });
    LargeArray<Eigen::Vector3f> points;
    for (const auto& chunk : chunks) points.insert(points.end(), chunk.begin(), chunk.end());
    return points;
}

/// Steps in azimuth and elevation are equal.
Raster rasterOf(const TripodStation& station, double rays) {
    const double shape = (station.highest_rad - station.lowest_rad) / (2 * std::numbers::pi);
    const int rows = std::max(4, static_cast<int>(std::lround(std::sqrt(rays * shape))));
    return {rows, std::max(4, static_cast<int>(std::lround(rays / rows)))};
}

}  // namespace

PointCloud scanFromTripod(const TripodScene& scene, const TripodStation& station) {
    // A coarse turn tells which share of the rays comes back.
    const Raster coarse = rasterOf(station, 6000);
    const double share = std::max(0.02, static_cast<double>(scanRaster(scene, station, coarse).size()) /
                                            (static_cast<double>(coarse.rows) * coarse.columns));
    const Raster raster = rasterOf(station, static_cast<double>(station.points) / share);
    return {Eigen::Vector3d::Zero(), scanRaster(scene, station, raster), LargeArray<Eigen::Vector3f>{}, {}};
}

}  // namespace vestige
