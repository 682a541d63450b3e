#include <algorithm>
#include <array>

#include "core/base/Random.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/simulation/TripodPair.h"
#include "tests/bench/auto/Trial.h"

namespace vestige::bench {
namespace {

/// What a set of tripod stations asks for beyond the pair itself.
struct Station {
    TripodSceneKind kind = TripodSceneKind::street;
    std::size_t points = 60000;
    double rangeNoise_m = 0.003;
    double nearest_m = 3;  ///< between the stations
    double farthest_m = 12;
    bool otherPlace = false;   ///< the source stands in another scene
    bool half = false;         ///< each station sees half a turn, another half
    double outliers = 0;       ///< share of points anywhere
    bool far = false;          ///< the target in map coordinates
    bool tilted = false;       ///< the target lies askew, too
    double metresPerUnit = 1;  ///< of the source
};

/// The points in the half turn round `heading_rad`.
PointCloud sector(const PointCloud& cloud, double x, double y) {
    std::vector<std::uint32_t> kept;
    for (std::uint32_t i = 0; i < cloud.size(); ++i)
        if (cloud.point(i).x() * x + cloud.point(i).y() * y > 0) kept.push_back(i);
    return cloud.select(kept);
}

PointCloud withOutliers(const PointCloud& cloud, double share, std::uint64_t seed) {
    Random random(seed, 900);
    PointCloudBuilder builder;
    for (std::size_t i = 0; i < cloud.size(); ++i) builder.add(cloud.point(i));
    const Eigen::Vector3d centre = cloud.bounds().centre();
    const Eigen::Vector3d size = 0.5 * (cloud.bounds().max - cloud.bounds().min);
    const auto count = static_cast<std::size_t>(share * static_cast<double>(cloud.size()));
    for (std::size_t i = 0; i < count; ++i)
        builder.add(centre + Eigen::Vector3d(random.uniform(-1.5, 1.5) * size.x(),
                                             random.uniform(-1.5, 1.5) * size.y(),
                                             random.uniform(-1.5, 1.5) * size.z()));
    return std::move(builder).build();
}

Trial stationTrial(const Station& station, std::uint64_t number) {
    Random random(600000 + number, 77);
    TripodPairOptions options;
    options.points = station.points;
    options.seed = 600000 + number;
    options.scene = {station.kind, 600000 + number};
    options.distance_m = random.uniform(station.nearest_m, station.farthest_m);
    options.yaw_deg = random.uniform(-70, 70);
    options.rangeNoise_m = station.rangeNoise_m;
    if (station.otherPlace) options.sourceScene = TripodSceneOptions{station.kind, 700000 + number};
    TripodPair pair = simulateTripodPair(options);
    Similarity truth{pair.targetFromSource(), 1};
    if (station.half) {
        pair.target = sector(pair.target, 1, 0);
        // Two half turns that share a quarter.
        const Eigen::Vector3d ahead = truth.pose.linear().transpose() * Eigen::Vector3d(0, 1, 0);
        pair.source = sector(pair.source, ahead.x(), ahead.y());
    }
    if (station.outliers > 0) {
        pair.target = withOutliers(pair.target, station.outliers, number);
        pair.source = withOutliers(pair.source, station.outliers, number + 1000);
    }
    if (station.far || station.tilted) {
        Similarity there;
        if (station.tilted) there.pose = anyPose(number + 5000, 5);
        if (station.far) there.pose.translation() += Eigen::Vector3d(518440.25, 4326120.5, 33.125);
        pair.target = pair.target.transformed(there);
        truth = there * truth;
    }
    Trial trial{std::make_shared<TriangleMesh>(TriangleMesh{std::move(pair.target), {}}),
                {std::move(pair.source), {}},
                truth,
                {},
                pair.overlaps,
                {}};
    moveAway(trial, number, station.metresPerUnit);
    return trial;
}

std::vector<std::pair<std::string, Station>> stations() {
    std::vector<std::pair<std::string, Station>> all;
    const auto add = [&](const char* name) -> Station& {
        all.emplace_back(name, Station());
        return all.back().second;
    };
    add("streets");
    add("streets-tilted").tilted = true;
    add("streets-1M").points = 1000000;
    add("streets-15k").points = 15000;
    add("streets-30mm").rangeNoise_m = 0.03;
    add("streets-half").half = true;
    add("streets-outliers").outliers = 0.02;
    add("streets-utm").far = true;
    add("streets-mm").metresPerUnit = 0.001;
    add("halls").kind = TripodSceneKind::hall;
    add("fields").kind = TripodSceneKind::field;
    add("bare-road").kind = TripodSceneKind::bareRoad;
    add("streets-elsewhere").otherPlace = true;
    Station& hall = add("halls-elsewhere");
    hall.kind = TripodSceneKind::hall;
    hall.otherPlace = true;
    return all;
}

}  // namespace

std::optional<TrialSet> simulatedSet(const std::string& name) {
    for (const auto& [known, station] : stations())
        if (known == name)
            return TrialSet{name, 0.1, 1, [station = station](std::uint64_t number) {
                                return stationTrial(station, number);
                            }};
    return std::nullopt;
}

std::vector<std::string> simulatedSets() {
    std::vector<std::string> names;
    for (const auto& [name, station] : stations()) names.push_back(name);
    return names;
}

}  // namespace vestige::bench
