#include "core/simulation/TripodPair.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/Random.h"
#include "core/base/Units.h"
#include "core/simulation/shapes/Roadside.h"

namespace vestige {
namespace {

using Point = Eigen::Vector3d;
constexpr float kAbove = 2.4F;  ///< metres over the site's zero, under a hall's ceiling

std::optional<double> groundAt(const TripodScene& scene, double x, double y) {
    const auto below = scene.tracer().cast({static_cast<float>(x), static_cast<float>(y), kAbove},
                                           -Eigen::Vector3f::UnitZ(), 0, 2 * kAbove);
    if (!below) return std::nullopt;
    return static_cast<double>(kAbove - below->distance);
}

/// The scanner's head over the ground at (x, y), when a tripod can stand there: level ground below and no
/// object within arm's reach.
std::optional<Point> standAt(const TripodScene& scene, double x, double y, double height) {
    const auto ground = groundAt(scene, x, y);
    if (!ground) return std::nullopt;
    constexpr double kStep = 0.8;
    constexpr double kLevel = 0.35;
    for (const auto& [dx, dy] : {std::pair{kStep, 0.0}, {-kStep, 0.0}, {0.0, kStep}, {0.0, -kStep}}) {
        const auto beside = groundAt(scene, x + dx, y + dy);
        if (!beside || std::abs(*beside - *ground) > kLevel) return std::nullopt;  // on top of a car
    }
    for (const double level : {kLevel, 1.0, height}) {
        const Eigen::Vector3f from = Point(x, y, *ground + level).cast<float>();
        for (int step = 0; step < 24; ++step) {
            const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(step) / 24;
            if (scene.tracer().cast(from, {std::cos(angle), std::sin(angle), 0}, 0, 0.9F))
                return std::nullopt;
        }
    }
    return Point(x, y, *ground + height);
}

Pose levelled(const Point& head, double yaw_rad) {
    Pose pose = Pose::Identity();
    pose.linear() = Eigen::AngleAxisd(yaw_rad, Point::UnitZ()).toRotationMatrix();
    pose.translation() = head;
    return pose;
}

/// Random places along the road until a tripod can stand at both; the last ones tried when none is found in
/// a cluttered scene.
void placeStations(const TripodScene& targetScene, const TripodScene& sourceScene,
                   const TripodPairOptions& options, TripodPair& pair) {
    Random random(options.seed, 400);
    const double turn = random.uniform(-std::numbers::pi, std::numbers::pi);
    for (int attempt = 0; attempt < 200; ++attempt) {
        const double bearing = radians(random.uniform(-25, 25));
        const Point middle(random.uniform(-3, 3), random.uniform(-1.5, 1.5), 0);
        const Point half = 0.5 * options.distance_m * Point(std::cos(bearing), std::sin(bearing), 0);
        const Point a = middle - half;
        const Point b = middle + half;
        const double heightA = random.uniform(1.55, 1.85);
        const double heightB = random.uniform(1.55, 1.85);
        const bool onPavement = std::max(std::abs(a.y()), std::abs(b.y())) > kRoadHalfWidth + 2;
        const auto headA = standAt(targetScene, a.x(), a.y(), heightA);
        const auto headB = standAt(sourceScene, b.x(), b.y(), heightB);
        pair.siteFromTarget = levelled(headA.value_or(a + Point(0, 0, heightA)), turn);
        pair.siteFromSource =
            levelled(headB.value_or(b + Point(0, 0, heightB)), turn + radians(options.yaw_deg));
        if (headA && headB && !onPavement) return;
    }
}

}  // namespace

TripodPair simulateTripodPair(const TripodScene& targetScene, const TripodScene& sourceScene,
                              const TripodPairOptions& options) {
    TripodPair pair;
    pair.overlaps = &targetScene == &sourceScene;
    placeStations(targetScene, sourceScene, options, pair);
    TripodStation station;
    station.points = options.points;
    station.rangeNoise_m = options.rangeNoise_m;
    station.siteFromScanner = pair.siteFromTarget;
    station.seed = 2 * options.seed;
    pair.target = scanFromTripod(targetScene, station);
    station.siteFromScanner = pair.siteFromSource;
    station.seed = 2 * options.seed + 1;
    pair.source = scanFromTripod(sourceScene, station);
    return pair;
}

TripodPair simulateTripodPair(const TripodPairOptions& options) {
    const TripodScene scene(options.scene);
    if (!options.sourceScene) return simulateTripodPair(scene, scene, options);
    return simulateTripodPair(scene, TripodScene(*options.sourceScene), options);
}

Pose wrongPose(const Pose& truth, double distance_m, double angle_deg, std::uint64_t seed) {
    Random random(seed, 500);
    const auto direction = [&random]() -> Point {
        const double x = random.normal();
        const double y = random.normal();
        const double z = random.normal();
        return Point(x, y, z).normalized();
    };
    Pose wrong = truth;
    wrong.linear() = truth.linear() * Eigen::AngleAxisd(radians(angle_deg), direction()).toRotationMatrix();
    wrong.translation() += distance_m * direction();
    return wrong;
}

}  // namespace vestige
