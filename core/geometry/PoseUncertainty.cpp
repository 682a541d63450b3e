#include "core/geometry/PoseUncertainty.h"

namespace vestige {
namespace {

Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v) {
    Eigen::Matrix3d matrix;
    matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return matrix;
}

}  // namespace

Eigen::Matrix3d PoseUncertainty::at(const Eigen::Vector3d& point_m) const {
    return about(point_m).covariance.topLeftCorner<3, 3>();
}

PoseUncertainty PoseUncertainty::about(const Eigen::Vector3d& pivot) const {
    // t at the new pivot is t + w x (pivot - pivot_m).
    Matrix6d carry = Matrix6d::Identity();
    carry.topRightCorner<3, 3>() = -crossMatrix(pivot - pivot_m);
    return {carry * covariance * carry.transpose(), pivot};
}

std::array<double, 36> rowMajor(const Matrix6d& matrix) {
    std::array<double, 36> values{};
    for (int row = 0; row < 6; ++row)
        for (int column = 0; column < 6; ++column)
            values[static_cast<std::size_t>(6 * row + column)] = matrix(row, column);
    return values;
}

}  // namespace vestige
