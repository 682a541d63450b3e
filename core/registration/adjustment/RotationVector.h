#pragma once

#include <Eigen/Core>

namespace vestige {

/// v x u = crossMatrix(v) u.
Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v);
/// The rotation by |w| radians about w (Rodrigues).
Eigen::Matrix3d rotationExp(const Eigen::Vector3d& w);
/// The w of least length with rotationExp(w) = rotation; at half a turn either of the two.
Eigen::Vector3d rotationLog(const Eigen::Matrix3d& rotation);
/// J with rotationLog(rotationExp(d) rotationExp(w)) = w + J d + O(d^2), |w| < pi (Sola, Deray, Atchuthan
/// 2018, eq. 146: the inverse of the left Jacobian).
Eigen::Matrix3d inverseLeftJacobian(const Eigen::Vector3d& w);

}  // namespace vestige
