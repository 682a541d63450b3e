#include "core/registration/global/SurfaceCheck.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/registration/global/NeighbourCells.h"
#include "core/registration/global/PoseFit.h"
#include "core/registration/global/SmallTurn.h"

namespace vestige {

namespace {

/// So many target points to a surfel count half of what many would: fewer leave the target's noise.
constexpr double kPointsToTrust = 4;

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

std::vector<SurfaceReference::Neighbours> neighboursOf(const Surfels& surfels) {
    constexpr float kNear = 2.5F;  // voxels
    constexpr float kAlongside = 0.85F;
    const NeighbourCells cells(surfels.points, kNear * static_cast<float>(surfels.voxel_m));
    std::vector<std::vector<SurfaceReference::Neighbours>> later(surfels.size());
    cells.forEach([&](std::uint32_t one, std::span<const NeighbourCells::Neighbour> near) {
        for (const auto& [other, squaredDistance] : near) {
            const float cosine = surfels.normals[one].dot(surfels.normals[other]);
            if (other > one && std::abs(cosine) > kAlongside)
                later[one].push_back({one, other, cosine > 0 ? 1.0F : -1.0F});
        }
    });
    std::vector<SurfaceReference::Neighbours> all;
    for (const auto& some : later) all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace

SurfaceReference surfaceReference(std::span<const Eigen::Vector3f> points, const SurfaceLookup& source) {
    constexpr float kFlat = 0.1F;  // of a cell: standard deviation of points that halves a surfel's weight
    const auto cell = static_cast<float>(source.cell_m());
    PlaneDistances distances = planeDistances(points, source, Eigen::Isometry3f::Identity(), 2 * cell);
    SurfaceReference reference{std::move(distances.mean), directionWeights(source.surfels()), {}};
    for (std::size_t i = 0; i < reference.weight.size(); ++i) {
        const float mean = reference.offset[i];
        const float share = std::max(0.0F, distances.square[i] - mean * mean) / (kFlat * kFlat * cell * cell);
        reference.weight[i] /= 1 + share;
    }
    reference.neighbours = neighboursOf(source.surfels());
    return reference;
}

SurfaceCheck::SurfaceCheck(std::span<const Eigen::Vector3f> points, const SurfaceLookup& source,
                           const SurfaceReference& reference)
    : points_(points), source_(source), reference_(reference) {}

SurfaceCheck::Offsets SurfaceCheck::offsets(const Eigen::Isometry3d& pose, double reach_m) const {
    PlaneDistances distances =
        planeDistances(points_, source_, pose.inverse().cast<float>(), static_cast<float>(reach_m));
    for (std::size_t i = 0; i < distances.mean.size(); ++i) distances.mean[i] -= reference_.offset[i];
    return {std::move(distances.mean), std::move(distances.count)};
}

Eigen::Isometry3d SurfaceCheck::refined(const Eigen::Isometry3d& pose, double tolerance_m, int steps) const {
    const Surfels& surface = source_.surfels();
    Eigen::Isometry3d sourceFromTarget = pose.inverse();
    for (int step = 0; step < steps; ++step) {
        const Offsets found = offsets(sourceFromTarget.inverse(), tolerance_m);
        PlaneEquations equations;
        for (std::size_t i = 0; i < surface.size(); ++i) {
            if (found.points[i] == 0) continue;
            const double share = found.mean[i] / tolerance_m;
            const double inside = std::max(0.0, 1 - share * share);
            const double points = found.points[i];
            equations.add(surface.points[i], surface.normals[i], found.mean[i],
                          reference_.weight[i] * inside * inside * points / (points + kPointsToTrust));
        }
        const SmallTurn turn = equations.solve();
        sourceFromTarget = turn.pose * sourceFromTarget;
        if (turn.size < 1e-3 * tolerance_m) break;
    }
    return sourceFromTarget.inverse();
}

double Evidence::mostMismatch_m2() const {
    return std::max(0.0, mismatch_m2) + mismatchError_m2;
}

Evidence evidenceOf(const SurfaceCheck::Offsets& offsets, const SurfaceReference& reference, double sigma_m) {
    Evidence evidence;
    double all = 0;
    for (std::size_t i = 0; i < offsets.mean.size(); ++i) {
        all += reference.weight[i];
        if (offsets.points[i] == 0) continue;
        const double share = offsets.mean[i] / (2 * sigma_m);
        evidence.coverage += reference.weight[i];
        evidence.agreement += reference.weight[i] * std::max(-1.0, 1 - share * share);
    }
    if (evidence.coverage > 0) evidence.agreement /= evidence.coverage;
    if (all > 0) evidence.coverage /= all;
    double weights = 0;
    double squares = 0;
    for (const auto& [one, other, sign] : reference.neighbours) {
        if (offsets.points[one] == 0 || offsets.points[other] == 0) continue;
        const double weight = std::sqrt(static_cast<double>(reference.weight[one]) * reference.weight[other] *
                                        offsets.points[one] * offsets.points[other]);
        const double product = static_cast<double>(sign) * offsets.mean[one] * offsets.mean[other];
        weights += weight;
        evidence.mismatch_m2 += weight * product;
        squares += weight * weight * product * product;
    }
    if (weights > 0) {
        evidence.mismatch_m2 /= weights;
        evidence.mismatchError_m2 = std::sqrt(squares) / weights;
    } else {
        evidence.mismatchError_m2 = std::numeric_limits<double>::infinity();
    }
    return evidence;
}

double offsetScale(const SurfaceCheck::Offsets& offsets, std::size_t least) {
    constexpr double kSigmasPerMedian = 0.6745;
    std::vector<float> sizes;
    for (std::size_t i = 0; i < offsets.mean.size(); ++i)
        if (offsets.points[i] > 0) sizes.push_back(std::abs(offsets.mean[i]));
    if (sizes.size() < std::max<std::size_t>(1, least)) return std::numeric_limits<double>::infinity();
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    return static_cast<double>(*middle) / kSigmasPerMedian;
}

std::size_t knownOffsets(const SurfaceCheck::Offsets& offsets) {
    return static_cast<std::size_t>(std::count_if(offsets.points.begin(), offsets.points.end(),
                                                  [](std::uint32_t points) { return points > 0; }));
}

}  // namespace vestige
