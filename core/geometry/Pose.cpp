#include "core/geometry/Pose.h"

#include <Eigen/SVD>
#include <cmath>

namespace vestige {

Similarity Similarity::inverse() const {
    Similarity inverse;
    inverse.scale = 1 / scale;
    inverse.pose.linear() = pose.linear().transpose();
    inverse.pose.translation() = -(pose.linear().transpose() * pose.translation()) / scale;
    return inverse;
}

Similarity Similarity::operator*(const Similarity& other) const {
    Similarity product;
    product.scale = scale * other.scale;
    product.pose.linear() = pose.linear() * other.pose.linear();
    product.pose.translation() = pose * (scale * other.pose.translation());
    return product;
}

double rotationAngle(const Eigen::Matrix3d& rotation) {
    const Eigen::Vector3d axis(rotation(2, 1) - rotation(1, 2), rotation(0, 2) - rotation(2, 0),
                               rotation(1, 0) - rotation(0, 1));
    return std::atan2(axis.norm(), rotation.trace() - 1);
}

std::array<double, 16> rowMajor(const Pose& pose) {
    std::array<double, 16> values{};
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            values[static_cast<std::size_t>(4 * row + column)] = pose.matrix()(row, column);
    return values;
}

Result<Pose> poseFromRowMajor(const std::array<double, 16>& matrix, double tolerance) {
    Eigen::Matrix4d full;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            full(row, column) = matrix[static_cast<std::size_t>(4 * row + column)];
    if (!full.allFinite()) return fail(ErrorCode::input, "a number of the 4x4 pose is not finite");
    if ((full.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).cwiseAbs().maxCoeff() > tolerance)
        return fail(ErrorCode::input, "the last row of the 4x4 pose is not 0 0 0 1", {},
                    "expected 16 numbers, row by row");
    const Eigen::Matrix3d rotation = full.topLeftCorner<3, 3>();
    const double departure =
        (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    if (departure > tolerance || rotation.determinant() < 0)
        return fail(ErrorCode::input, "the rotation of the 4x4 pose is not orthonormal and right-handed", {},
                    "a scale belongs in its own field");
    Pose pose = Pose::Identity();
    // Leaves an exactly written pose as it is, so that reading and writing it changes no bit.
    pose.linear() = departure > 1e-14 ? nearestRotation(rotation) : rotation;
    pose.translation() = full.topRightCorner<3, 1>();
    return pose;
}

Eigen::Matrix3d nearestRotation(const Eigen::Matrix3d& matrix) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Vector3d signs(1, 1, (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1);
    return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

}  // namespace vestige
