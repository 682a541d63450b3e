#include "core/registration/OverlapQuality.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/Parallel.h"

namespace vestige {
namespace {

/// Points by voxel: the points of one voxel are consecutive.
class PointsByVoxel {
  public:
    PointsByVoxel(std::span<const CellMoments> points, double size) : grid_(size), points_(points) {
        entries_.reserve(points.size());
        for (std::uint32_t i = 0; i < points.size(); ++i)
            entries_.push_back({keyOf(points[i].meanVector()), i});
        std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
            return a.key != b.key ? a.key < b.key : a.point < b.point;
        });
    }
    std::uint64_t keyOf(const Eigen::Vector3d& x) const { return grid_.key(x.x(), x.y(), x.z()); }

    /// The points within a voxel's edge of x.
    void near(const Eigen::Vector3d& x, std::vector<Eigen::Vector3d>& found) const {
        found.clear();
        const double limit = grid_.size() * grid_.size();
        const std::uint64_t middle = keyOf(x);
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy) {
                // Neighbours along x have consecutive keys.
                const std::uint64_t first = VoxelGrid::neighbour(middle, -1, dy, dz);
                if (first == VoxelGrid::kNoKey) continue;
                auto entry = std::lower_bound(entries_.begin(), entries_.end(), first,
                                              [](const Entry& e, std::uint64_t key) { return e.key < key; });
                for (; entry != entries_.end() && entry->key <= first + 2; ++entry) {
                    const Eigen::Vector3d point = points_[entry->point].meanVector();
                    if ((point - x).squaredNorm() <= limit) found.push_back(point);
                }
            }
    }
    std::size_t voxels() const {
        std::size_t count = 0;
        for (std::size_t i = 0; i < entries_.size(); ++i)
            count += i == 0 || entries_[i].key != entries_[i - 1].key;
        return count;
    }

  private:
    struct Entry {
        std::uint64_t key;
        std::uint32_t point;
    };
    VoxelGrid grid_;
    std::span<const CellMoments> points_;
    std::vector<Entry> entries_;
};

/// See overlapQuality; `near` is not empty.
double distanceToSurface(const Eigen::Vector3d& x, const std::vector<Eigen::Vector3d>& near) {
    constexpr std::size_t kPlanePoints = 6;
    constexpr double kPlaneWidth = 0.1;
    double nearest = std::numeric_limits<double>::infinity();
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : near) {
        nearest = std::min(nearest, (point - x).squaredNorm());
        mean += point;
    }
    nearest = std::sqrt(nearest);
    if (near.size() < kPlanePoints) return nearest;
    mean /= static_cast<double>(near.size());
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3d& point : near) scatter += (point - mean) * (point - mean).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
    if (solver.eigenvalues()[1] < kPlaneWidth * solver.eigenvalues()[2]) return nearest;
    return std::min(nearest, std::abs(solver.eigenvectors().col(0).dot(x - mean)));
}

struct Inliers {
    std::size_t count = 0;
    double squares = 0;
    std::vector<std::uint64_t> voxels;
    Inliers& operator+=(const Inliers& other) {
        count += other.count;
        squares += other.squares;
        voxels.insert(voxels.end(), other.voxels.begin(), other.voxels.end());
        return *this;
    }
};

}  // namespace

OverlapQuality overlapQuality(std::span<const CellMoments> target, const CentredSource& source,
                              const Pose& pose, double inlierDistance_m) {
    const PointsByVoxel index(target, inlierDistance_m);
    Inliers inliers =
        parallelSum(source.points.size(), 256, Inliers{}, [&](std::size_t begin, std::size_t end) {
            Inliers part;
            std::vector<Eigen::Vector3d> near;
            for (std::size_t i = begin; i < end; ++i) {
                const Eigen::Vector3d x = pose * source.points[i].cast<double>();
                index.near(x, near);
                if (near.empty()) continue;
                const double distance = distanceToSurface(x, near);
                ++part.count;
                part.squares += distance * distance;
                part.voxels.push_back(index.keyOf(x));
            }
            return part;
        });
    OverlapQuality quality;
    if (inliers.count == 0) return quality;
    std::sort(inliers.voxels.begin(), inliers.voxels.end());
    const auto last = std::unique(inliers.voxels.begin(), inliers.voxels.end());
    const auto share = [](auto part, auto whole) {
        return static_cast<double>(part) / static_cast<double>(whole);
    };
    quality.sourceShare = share(inliers.count, source.points.size());
    quality.targetShare = std::min(1.0, share(last - inliers.voxels.begin(), index.voxels()));
    quality.rmse_m = std::sqrt(inliers.squares / static_cast<double>(inliers.count));
    return quality;
}

}  // namespace vestige
