#include "core/measurement/kinds/PlaneThrough.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

namespace vestige {

double PlaneThrough::tilt_deg() const {
    return std::acos(std::min(1.0, std::abs(normal.z()))) * 180 / std::numbers::pi;
}

Result<PlaneThrough> planeThrough(std::span<const Eigen::Vector3d> points) {
    if (points.size() < 3) return fail(ErrorCode::input, "a plane needs three points");
    PlaneThrough plane;
    for (const auto& point : points) plane.centre += point / static_cast<double>(points.size());
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const auto& point : points) {
        const Eigen::Vector3d off = point - plane.centre;
        scatter += off * off.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(scatter);
    // The second axis tells a plane from a line; 1e-9 of it is what doubles of survey coordinates resolve.
    if (!(axes.eigenvalues()[1] > 1e-9 * axes.eigenvalues()[2]))
        return fail(ErrorCode::input, "the points of the plane lie on one line");
    plane.normal = axes.eigenvectors().col(0).normalized();
    Eigen::Index largest = 0;
    plane.normal.cwiseAbs().maxCoeff(&largest);
    if (plane.normal[largest] < 0) plane.normal = -plane.normal;
    plane.rms = std::sqrt(std::max(0.0, axes.eigenvalues()[0]) / static_cast<double>(points.size()));
    return plane;
}

}  // namespace vestige
