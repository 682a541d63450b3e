#include "tests/bench/filters/FilterClouds.h"

#include "core/base/Random.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/io/FormatRegistry.h"
#include "core/simulation/TripodPair.h"
#include "tests/support/TestPaths.h"

namespace vestige {
namespace {

std::optional<PointCloud> sharedCloud(const std::string& file) {
    const auto path = test::sharedFile(file);
    if (!path) return std::nullopt;
    auto read = readGeometry(*path);
    if (!read) return std::nullopt;
    return read->geometry.vertices.withAttributes({});
}

PointCloud tiled(const PointCloud& cloud, int columns, int rows) {
    const Eigen::Vector3d step = cloud.bounds().extent() + Eigen::Vector3d(1, 1, 0);
    PointCloudBuilder builder(cloud.origin());
    builder.reserve(cloud.size() * static_cast<std::size_t>(columns * rows));
    for (int x = 0; x < columns; ++x)
        for (int y = 0; y < rows; ++y)
            for (std::size_t i = 0; i < cloud.size(); ++i)
                builder.add(cloud.point(i) + Eigen::Vector3d(x * step.x(), y * step.y(), 0));
    return std::move(builder).build();
}

PointCloud tripodStation() {
    TripodPairOptions options;
    options.points = 1000000;
    return simulateTripodPair(options).target;
}

PointCloud overlaid(const PointCloud& cloud, int times, double sigma_m) {
    Random random(4);
    PointCloudBuilder builder(cloud.origin());
    builder.reserve(cloud.size() * static_cast<std::size_t>(times));
    for (int time = 0; time < times; ++time)
        for (std::size_t i = 0; i < cloud.size(); ++i) {
            const Eigen::Vector3d jitter(random.normal(), random.normal(), random.normal());
            builder.add(cloud.point(i) + sigma_m * jitter);
        }
    return std::move(builder).build();
}

}  // namespace

std::optional<PointCloud> filterCloud(const std::string& name) {
    if (name == "street") return sharedCloud("registration/street/target.ply");
    if (name == "tripod") return tripodStation();
    if (name == "tripod x10") return overlaid(tripodStation(), 10, 0.01);
    if (name != "room") return std::nullopt;
    const auto room = sharedCloud("registration/room/room_scan1.pcd");
    if (!room) return std::nullopt;
    return tiled(*room, 9, 10);
}

}  // namespace vestige
