#pragma once

#include <Eigen/Core>

#include "core/geometry/Pose.h"

namespace vestige {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// How far a pose targetFromSource may be off: the covariance of (t, w), metres and radians along the
/// target's axes, where the true pose is x -> exp(w) (pose x - pivot) + pivot + t.
struct PoseUncertainty {
    Matrix6d covariance = Matrix6d::Zero();
    Eigen::Vector3d pivot_m = Eigen::Vector3d::Zero();  ///< target's frame, metres; near the source

    /// Covariance (m^2) of where a source point lies in the target; `point_m` in the target's frame.
    Eigen::Matrix3d at(const Eigen::Vector3d& point_m) const;
    /// The same uncertainty about another pivot. `pivot = pose.translation()` gives the covariance of the
    /// pose matrix: of its translation column and of a turn in the target's axes.
    PoseUncertainty about(const Eigen::Vector3d& pivot_m) const;
};

/// The 36 values, row by row.
std::array<double, 36> rowMajor(const Matrix6d& matrix);

}  // namespace vestige
