#pragma once

#include <Eigen/Core>
#include <span>

#include "core/base/Result.h"

namespace vestige {

/// The plane of least squared distances to points.
struct PlaneThrough {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit; its first large component is positive
    double rms = 0;                                     ///< of the distances

    double signedDistance(const Eigen::Vector3d& point) const { return normal.dot(point - centre); }
    /// Angle to the level, degrees, 0 to 90.
    double tilt_deg() const;
};

/// Three points or more that are not on one line.
Result<PlaneThrough> planeThrough(std::span<const Eigen::Vector3d> points);

}  // namespace vestige
