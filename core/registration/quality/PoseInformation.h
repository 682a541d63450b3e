#pragma once

#include <span>

#include "core/geometry/PoseUncertainty.h"
#include "core/registration/quality/SurfaceMatches.h"

namespace vestige {

/// What the surfaces that agree say of a pose, linearised there: p = (t, r w) about `pivot_m`, metres, the
/// target's axes.
struct PoseInformation {
    Eigen::Vector3d pivot_m = Eigen::Vector3d::Zero();  ///< the source's middle in the target's frame
    double radius_m = 1;                                ///< r
    Matrix6d hessian = Matrix6d::Zero();  ///< sum of weight J J', 1 / m^2, without the part that the noise of
                                          ///< the normals makes up
    Matrix6d noise = Matrix6d::Zero();    ///< that part
    Matrix6d scatter = Matrix6d::Zero();  ///< sum over clusters of g g', g = sum of weight J distance
    Vector6d gradient = Vector6d::Zero();  ///< sum of all g
    double weight = 0;
    double sigma_m = 0;  ///< robust standard deviation of the distances (MAD)
    std::size_t clusters = 0;

    /// Whether the surfaces hold a direction: ten times better than the noise of their normals seems to.
    bool holds(const Vector6d& direction) const;
    /// (m^2, of p) of the least-squares pose: H^-1 (scatter + hold) H^-1, H the Hessian with a hold of one
    /// radius on every direction. Along the eigenvectors that surfaces do not hold noise passes for
    /// structure: there the standard deviation is one radius. Positive definite.
    Matrix6d covariance() const;
    /// To the least-squares pose, along the held directions.
    Vector6d step() const;
};

/// Point-to-plane least squares over the agreeing matches. A cell weighs as the inverse variance of its
/// distance (noise of both planes, a part that grows with the cell, and one that makes the median distance
/// right) and by Tukey's biweight. Cells within one cube of `cluster_m` share their error: their gradients
/// count as one (the sandwich of Liang and Zeger 1986), each made up for its own pull on the fit (Bell and
/// McCaffrey 2002).
PoseInformation poseInformation(std::span<const SurfaceMatch> matches, const std::vector<SurfaceCell>& cells,
                                double cluster_m);

}  // namespace vestige
