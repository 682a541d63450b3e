#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/geometry/Pose.h"

namespace vestige::bench {

/// How far a pose is off: the place of the source's origin (metres), the angle (radians).
struct PoseError {
    double translation_m = 0;
    double rotation_rad = 0;
};
PoseError poseError(const Pose& found, const Pose& truth);

/// One number to order errors by: how far a point 10 m from the source's origin is off at most.
double errorAt10m(const PoseError& error);

/// Not larger than `other`, where what is below the reference's own error counts as equal.
bool notLarger(const PoseError& error, const PoseError& other, const PoseError& reference);

/// Over 0.1 m off: the method did not find the pose, and its time is only a lower bound.
inline constexpr double kMissed_m = 0.1;
inline bool missed(const PoseError& error) {
    return error.translation_m > kMissed_m;
}

/// One run at one setting.
struct SettingRun {
    double leaf_m = 0;
    double seconds = 0;
    PoseError error;
};

/// The setting that a peer counts with: the fastest of those whose error is not larger than ours, else the
/// most accurate one. Nothing for no runs.
std::optional<std::size_t> countingSetting(std::span<const SettingRun> runs, const PoseError& ours,
                                           const PoseError& reference);

/// The middle value, or the mean of the two middle ones; values must not be empty.
double median(std::vector<double> values);
double minimum(const std::vector<double>& values);

/// times[round][repetition] of one contender; a round without times was refused.
using RoundTimes = std::vector<std::vector<double>>;
/// median(peer) / median(ours) of each round that both have.
std::vector<double> ratiosByRound(const RoundTimes& peer, const RoundTimes& ours);

}  // namespace vestige::bench
