#pragma once

#include <Eigen/Geometry>
#include <array>

#include "core/base/Result.h"

namespace vestige {

/// A rigid motion: x -> R x + t, metres. Variables name their frames: targetFromSource.
using Pose = Eigen::Isometry3d;

/// A pose behind a change of unit: x -> R (scale x) + t. `scale` is metres per unit of the source (0.001 for
/// a scan in millimetres) and never inside the rotation.
struct Similarity {
    Pose pose = Pose::Identity();
    double scale = 1;

    Eigen::Vector3d operator*(const Eigen::Vector3d& x) const { return pose * (scale * x); }
    Similarity inverse() const;
    /// (a * b) maps x to a(b(x)).
    Similarity operator*(const Similarity& other) const;
    bool isIdentity() const { return scale == 1 && pose.matrix() == Eigen::Matrix4d::Identity(); }
};

/// Angle of a rotation, 0 to pi, in radians; accurate for small angles too.
double rotationAngle(const Eigen::Matrix3d& rotation);

/// The 4x4 matrix, row by row.
std::array<double, 16> rowMajor(const Pose& pose);
/// The inverse of rowMajor. ErrorCode::input unless the last row is 0 0 0 1 and the rotation is orthonormal
/// to `tolerance` and right-handed; the rotation is then made exactly orthonormal.
Result<Pose> poseFromRowMajor(const std::array<double, 16>& matrix, double tolerance = 1e-4);

/// The nearest rotation matrix in the least-squares sense (singular value decomposition).
Eigen::Matrix3d nearestRotation(const Eigen::Matrix3d& matrix);

}  // namespace vestige
