#pragma once

#include <Eigen/Core>
#include <span>

#include "core/base/Result.h"

namespace vestige {

/// The circle of least squared distances to points of a plane.
struct CircleThrough {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    double radius = 0;
    double scatter = 0;        ///< sqrt(RSS / (n - 3)); 0 with three points
    double radiusPerUnit = 0;  ///< standard uncertainty of the radius for points of standard uncertainty 1
    std::size_t degreesOfFreedom = 0;  ///< n - 3
};

/// Three points or more that are not on one line. Taubin's algebraic fit (IEEE PAMI 13, 1991), then
/// Gauss-Newton on the distances in the parameters A (x^2 + y^2) + E (x cos t + y sin t) + D = 0 with E^2 = 1
/// + 4 A D (Chernov and Lesort, J. Math. Imaging Vis. 23, 2005), which stay regular for arcs so flat that the
/// centre runs away.
Result<CircleThrough> circleThrough(std::span<const Eigen::Vector2d> points);

}  // namespace vestige
