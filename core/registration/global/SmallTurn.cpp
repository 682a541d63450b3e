#include "core/registration/global/SmallTurn.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace vestige {
namespace {

constexpr double kHeldLeast = 1e-6;  // of the largest

/// The rotation by 2 atan(|w| / 2) about w: exactly orthonormal, and without a library's sine.
Eigen::Matrix3d cayley(const Eigen::Vector3d& w) {
    return Eigen::Quaterniond(1, 0.5 * w.x(), 0.5 * w.y(), 0.5 * w.z()).normalized().toRotationMatrix();
}

}  // namespace

void PlaneEquations::add(const Eigen::Vector3f& point, const Eigen::Vector3f& normal, double distance,
                         double weight) {
    const Eigen::Vector3d p = point.cast<double>();
    const Eigen::Vector3d n = normal.cast<double>();
    Vector6d row;
    row << n, p.cross(n);
    squares_ += weight * row * row.transpose();
    products_ += weight * distance * row;
    weight_ += weight;
    sum_ += weight * p;
    norms_ += weight * p.squaredNorm();
}

SmallTurn PlaneEquations::solve() const {
    SmallTurn turn;
    if (!(weight_ > 0)) return turn;
    // About the middle of the points, turns in metres at their radius.
    const Eigen::Vector3d middle = sum_ / weight_;
    const double radius = std::sqrt(std::max(norms_ / weight_ - middle.squaredNorm(), 1e-12));
    Matrix6d centred = Matrix6d::Identity();  // (t, r w) about the middle -> (t, w) about the origin
    centred.topRightCorner<3, 3>() << 0, -middle.z(), middle.y(), middle.z(), 0, -middle.x(), -middle.y(),
        middle.x(), 0;
    centred.topRightCorner<3, 3>() /= radius;
    centred.bottomRightCorner<3, 3>() /= radius;
    Matrix6d squares = centred.transpose() * squares_ * centred;
    const Vector6d products = centred.transpose() * products_;
    squares.diagonal().array() += kHeldLeast * squares.diagonal().maxCoeff();
    const Vector6d change = -squares.ldlt().solve(products);
    if (!change.allFinite()) return turn;
    const Eigen::Vector3d w = change.tail<3>() / radius;
    turn.pose.linear() = cayley(w);
    turn.pose.translation() = middle - turn.pose.linear() * middle + change.head<3>();
    turn.size = change.norm();
    return turn;
}

}  // namespace vestige
