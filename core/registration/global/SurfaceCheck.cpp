#include "core/registration/global/SurfaceCheck.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/registration/global/SmallTurn.h"

namespace vestige {

SurfaceCheck::SurfaceCheck(std::span<const Eigen::Vector3f> points, const SurfaceLookup& source,
                           std::span<const float> weights)
    : points_(points), source_(source), weights_(weights) {}

std::vector<float> SurfaceCheck::offsets(const Eigen::Isometry3d& pose, double reach_m) const {
    const Surfels& surface = source_.surfels();
    const Eigen::Isometry3f sourceFromTarget = pose.inverse().cast<float>();
    std::vector<float> mean(surface.size(), 0.0F);
    std::vector<std::uint32_t> count(surface.size(), 0);
    const auto reach = static_cast<float>(reach_m);
    for (const Eigen::Vector3f& point : points_) {
        const Eigen::Vector3f x = sourceFromTarget * point;
        const std::uint32_t at = source_.near(x);
        if (at == SurfaceLookup::kNone) continue;
        const float distance = surface.normals[at].dot(x - surface.points[at]);
        if (std::abs(distance) > reach) continue;
        mean[at] += distance;
        ++count[at];
    }
    for (std::size_t i = 0; i < surface.size(); ++i)
        mean[i] =
            count[i] > 0 ? mean[i] / static_cast<float>(count[i]) : std::numeric_limits<float>::quiet_NaN();
    return mean;
}

Eigen::Isometry3d SurfaceCheck::refined(const Eigen::Isometry3d& pose, double tolerance_m, int steps) const {
    const Surfels& surface = source_.surfels();
    Eigen::Isometry3d sourceFromTarget = pose.inverse();
    for (int step = 0; step < steps; ++step) {
        const std::vector<float> distances = offsets(sourceFromTarget.inverse(), tolerance_m);
        PlaneEquations equations;
        for (std::size_t i = 0; i < surface.size(); ++i) {
            if (std::isnan(distances[i])) continue;
            const double share = distances[i] / tolerance_m;
            const double inside = 1 - share * share;
            equations.add(surface.points[i], surface.normals[i], distances[i], weights_[i] * inside * inside);
        }
        const SmallTurn turn = equations.solve();
        sourceFromTarget = turn.pose * sourceFromTarget;
        if (turn.size < 1e-3 * tolerance_m) break;
    }
    return sourceFromTarget.inverse();
}

Evidence evidenceOf(std::span<const float> offsets, std::span<const float> weights, double sigma_m) {
    Evidence evidence;
    double all = 0;
    for (std::size_t i = 0; i < offsets.size(); ++i) {
        all += weights[i];
        if (std::isnan(offsets[i])) continue;
        const double share = offsets[i] / (2 * sigma_m);
        evidence.coverage += weights[i];
        evidence.agreement += weights[i] * std::max(-1.0, 1 - share * share);
    }
    if (evidence.coverage > 0) evidence.agreement /= evidence.coverage;
    if (all > 0) evidence.coverage /= all;
    return evidence;
}

double offsetScale(std::span<const float> offsets, std::size_t least) {
    constexpr double kSigmasPerMedian = 0.6745;
    std::vector<float> sizes;
    for (const float offset : offsets)
        if (!std::isnan(offset)) sizes.push_back(std::abs(offset));
    if (sizes.size() < std::max<std::size_t>(1, least)) return std::numeric_limits<double>::infinity();
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    return static_cast<double>(*middle) / kSigmasPerMedian;
}

std::size_t knownOffsets(std::span<const float> offsets) {
    return static_cast<std::size_t>(
        std::count_if(offsets.begin(), offsets.end(), [](float offset) { return !std::isnan(offset); }));
}

}  // namespace vestige
