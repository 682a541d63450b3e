#include "core/pipeline/TargetDistances.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/base/Parallel.h"

namespace vestige {
namespace {

constexpr std::size_t kNeighbours = 8;

/// In the target's unit; `found` is not empty, nearest first.
double distanceTo(const PointCloud& target, const std::vector<Octree::Neighbour>& found,
                  const Eigen::Vector3d& offset) {
    const double nearest = std::sqrt(static_cast<double>(found.front().squaredDistance));
    if (found.size() < kNeighbours) return nearest;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const auto& neighbour : found) mean += target.offsets()[neighbour.point].cast<double>();
    mean /= static_cast<double>(found.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const auto& neighbour : found) {
        const Eigen::Vector3d d = target.offsets()[neighbour.point].cast<double>() - mean;
        spread += d * d.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
    const Eigen::Vector3d values = solver.eigenvalues();
    const double along = (offset - mean).dot(solver.eigenvectors().col(0));
    const double aside = std::sqrt(std::max(0.0, (offset - mean).squaredNorm() - along * along));
    const bool plane = values[0] < 0.1 * values[1];
    const bool around = aside * aside <= 2 * values[2] / static_cast<double>(found.size() - 1);
    return plane && around ? std::min(std::abs(along), nearest) : nearest;
}

}  // namespace

std::vector<float> targetDistances(const Octree& target, const Similarity& worldFromTarget,
                                   const PointCloud& source, const Similarity& worldFromSource) {
    std::vector<float> distances(source.size(), 0);
    if (target.cloud().empty()) return distances;
    const Similarity targetFromSource = worldFromTarget.inverse() * worldFromSource;
    parallelFor(source.size(), 2048, [&](std::size_t begin, std::size_t end) {
        std::vector<Octree::Neighbour> found;
        for (std::size_t i = begin; i < end; ++i) {
            const Eigen::Vector3d offset = targetFromSource * source.point(i) - target.cloud().origin();
            target.nearest(offset.cast<float>(), kNeighbours, found);
            distances[i] =
                static_cast<float>(worldFromTarget.scale * distanceTo(target.cloud(), found, offset));
        }
    });
    return distances;
}

}  // namespace vestige
