#pragma once

#include "core/geometry/PointCloud.h"

namespace vestige {

/// PointCloud::point for the innermost loops, which the compiler does not make a call of, and without going to
/// the nearest place of a LAS file's grid: below half a step of it off (CoordinateGrid), far below what filters
/// and registration tell apart.
class WorldPoints {
  public:
    explicit WorldPoints(const PointCloud& cloud)
        : origin_(cloud.origin()),
          offsets_(cloud.offsets().data()),
          residuals_(cloud.residuals().empty() ? nullptr : cloud.residuals().data()) {}

    double along(int axis, std::size_t i) const {
        const double world = origin_[axis] + static_cast<double>(offsets_[i][axis]);
        return residuals_ ? world + static_cast<double>(residuals_[i][axis]) : world;
    }
    Eigen::Vector3d operator[](std::size_t i) const { return {along(0, i), along(1, i), along(2, i)}; }

    /// Starts loading a point that will be asked for soon: in sorted order each lies elsewhere in memory.
    void prefetch(std::size_t i) const { __builtin_prefetch(offsets_ + i); }

  private:
    Eigen::Vector3d origin_;
    const Eigen::Vector3f* offsets_;
    const Eigen::Vector3f* residuals_;
};

}  // namespace vestige
