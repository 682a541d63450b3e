#include "core/registration/adjustment/RotationVector.h"

#include <Eigen/Geometry>
#include <cmath>

namespace vestige {

Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v) {
    Eigen::Matrix3d matrix;
    matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return matrix;
}

Eigen::Matrix3d rotationExp(const Eigen::Vector3d& w) {
    const double angle = w.norm();
    if (angle == 0) return Eigen::Matrix3d::Identity();
    return Eigen::AngleAxisd(angle, w / angle).toRotationMatrix();
}

Eigen::Vector3d rotationLog(const Eigen::Matrix3d& rotation) {
    Eigen::Quaterniond turn(rotation);
    if (turn.w() < 0) turn.coeffs() = -turn.coeffs();
    const double half = turn.vec().norm();
    if (half < 1e-12) return 2 * turn.vec();
    return (2 * std::atan2(half, turn.w()) / half) * turn.vec();
}

Eigen::Matrix3d inverseLeftJacobian(const Eigen::Vector3d& w) {
    const Eigen::Matrix3d cross = crossMatrix(w);
    const double angle = w.norm();
    // The factor of cross^2 is 1/12 + angle^2 / 720 + O(angle^4).
    const double factor = angle < 1e-3
                              ? 1.0 / 12 + angle * angle / 720
                              : 1 / (angle * angle) - (1 + std::cos(angle)) / (2 * angle * std::sin(angle));
    return Eigen::Matrix3d::Identity() - 0.5 * cross + factor * cross * cross;
}

}  // namespace vestige
