#include "tests/bench/registration/Scores.h"

#include <algorithm>

namespace vestige::bench {

PoseError poseError(const Pose& found, const Pose& truth) {
    return {(found.translation() - truth.translation()).norm(),
            rotationAngle(truth.linear().transpose() * found.linear())};
}

double errorAt10m(const PoseError& error) {
    return error.translation_m + 10 * error.rotation_rad;
}

bool notLarger(const PoseError& error, const PoseError& other, const PoseError& reference) {
    return error.translation_m <= std::max(other.translation_m, reference.translation_m) &&
           error.rotation_rad <= std::max(other.rotation_rad, reference.rotation_rad);
}

std::optional<std::size_t> countingSetting(std::span<const SettingRun> runs, const PoseError& ours,
                                           const PoseError& reference) {
    std::optional<std::size_t> fastest;
    std::optional<std::size_t> closest;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (!closest || errorAt10m(runs[i].error) < errorAt10m(runs[*closest].error)) closest = i;
        if (!notLarger(runs[i].error, ours, reference)) continue;
        if (!fastest || runs[i].seconds < runs[*fastest].seconds) fastest = i;
    }
    return fastest ? fastest : closest;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

double minimum(const std::vector<double>& values) {
    return *std::min_element(values.begin(), values.end());
}

std::vector<double> ratiosByRound(const RoundTimes& peer, const RoundTimes& ours) {
    std::vector<double> ratios;
    for (std::size_t round = 0; round < std::min(peer.size(), ours.size()); ++round)
        if (!peer[round].empty() && !ours[round].empty())
            ratios.push_back(median(peer[round]) / median(ours[round]));
    return ratios;
}

}  // namespace vestige::bench
