#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/geometry/PointCloud.h"
#include "core/geometry/Pose.h"
#include "core/simulation/TripodScanner.h"
#include "core/simulation/TripodScene.h"

namespace vestige {

struct TripodPairOptions {
    TripodSceneOptions scene;
    /// The source scans this scene instead: a pair without overlap, whose `targetFromSource` means nothing.
    std::optional<TripodSceneOptions> sourceScene;
    std::size_t points = 60000;  ///< of each station, about
    double distance_m = 12.8;    ///< between the stations, level
    double yaw_deg = 27;         ///< between their frames
    double rangeNoise_m = 0.003;
    std::uint64_t seed = 1;  ///< where the stations stand, jitter and noise
};

/// Two stations of a tripod scanner, each cloud in its scanner's own levelled frame (metres, z up), and the
/// exact poses. No place is sampled by both.
struct TripodPair {
    PointCloud target;
    PointCloud source;
    Pose siteFromTarget = Pose::Identity();
    Pose siteFromSource = Pose::Identity();
    bool overlaps = true;  ///< both stand in one scene

    Pose targetFromSource() const { return siteFromTarget.inverse() * siteFromSource; }
};

/// Builds the scene and scans it: 60 000 points take about a tenth of a second.
TripodPair simulateTripodPair(const TripodPairOptions& options);
/// The same in scenes that are there already; `options.scene` and `sourceScene` are not looked at.
TripodPair simulateTripodPair(const TripodScene& targetScene, const TripodScene& sourceScene,
                              const TripodPairOptions& options);

/// `truth` with the source moved by exactly `distance_m` in a random direction and turned by exactly
/// `angle_deg` about a random axis through the source's origin: a first pose that is that wrong.
Pose wrongPose(const Pose& truth, double distance_m, double angle_deg, std::uint64_t seed);

}  // namespace vestige
