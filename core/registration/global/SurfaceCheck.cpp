#include "core/registration/global/SurfaceCheck.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/registration/global/PoseFit.h"
#include "core/registration/global/SmallTurn.h"

namespace vestige {

namespace {

/// Signed distances of points to the planes of the surfels they are nearest to.
struct PlaneDistances {
    explicit PlaneDistances(std::size_t surfels)
        : mean(surfels, 0.0F), square(surfels, 0.0F), count(surfels, 0) {}
    std::vector<float> mean;
    std::vector<float> square;  ///< mean squared
    std::vector<std::uint32_t> count;
};

PlaneDistances planeDistances(std::span<const Eigen::Vector3f> points, const SurfaceLookup& source,
                              const Eigen::Isometry3f& sourceFromPoints, float reach_m) {
    const Surfels& surface = source.surfels();
    PlaneDistances distances(surface.size());
    for (const Eigen::Vector3f& point : points) {
        const Eigen::Vector3f x = sourceFromPoints * point;
        const std::uint32_t at = source.near(x);
        if (at == SurfaceLookup::kNone) continue;
        const float distance = surface.normals[at].dot(x - surface.points[at]);
        if (std::abs(distance) > reach_m) continue;
        distances.mean[at] += distance;
        distances.square[at] += distance * distance;
        ++distances.count[at];
    }
    for (std::size_t i = 0; i < surface.size(); ++i) {
        const auto count = static_cast<float>(std::max<std::uint32_t>(1, distances.count[i]));
        distances.mean[i] /= count;
        distances.square[i] /= count;
    }
    return distances;
}

}  // namespace

SurfaceReference surfaceReference(std::span<const Eigen::Vector3f> points, const SurfaceLookup& source) {
    constexpr float kFlat = 0.1F;  // of a cell: standard deviation of points that halves a surfel's weight
    const auto cell = static_cast<float>(source.cell_m());
    PlaneDistances distances = planeDistances(points, source, Eigen::Isometry3f::Identity(), 2 * cell);
    SurfaceReference reference{std::move(distances.mean), directionWeights(source.surfels())};
    for (std::size_t i = 0; i < reference.weight.size(); ++i) {
        const float mean = reference.offset[i];
        const float share = std::max(0.0F, distances.square[i] - mean * mean) / (kFlat * kFlat * cell * cell);
        reference.weight[i] /= 1 + share;
    }
    return reference;
}

SurfaceCheck::SurfaceCheck(std::span<const Eigen::Vector3f> points, const SurfaceLookup& source,
                           const SurfaceReference& reference)
    : points_(points), source_(source), reference_(reference) {}

std::vector<float> SurfaceCheck::offsets(const Eigen::Isometry3d& pose, double reach_m) const {
    PlaneDistances distances =
        planeDistances(points_, source_, pose.inverse().cast<float>(), static_cast<float>(reach_m));
    for (std::size_t i = 0; i < distances.mean.size(); ++i)
        distances.mean[i] = distances.count[i] > 0 ? distances.mean[i] - reference_.offset[i]
                                                   : std::numeric_limits<float>::quiet_NaN();
    return std::move(distances.mean);
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
            const double inside = std::max(0.0, 1 - share * share);
            equations.add(surface.points[i], surface.normals[i], distances[i],
                          reference_.weight[i] * inside * inside);
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
