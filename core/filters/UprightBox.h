#pragma once

#include <Eigen/Core>
#include <span>

namespace vestige {

/// The smallest upright box round points: of all boxes with level sides, the one of least ground area.
struct UprightBox {
    double length_m = 0;  ///< the longer side
    double width_m = 0;
    double height_m = 0;
    float bottom_m = 0;  ///< least z of the points
};

/// By the hull of the ground plan, one of whose sides the least rectangle shares (Freeman and Shapira, 1975).
UprightBox uprightBox(std::span<const Eigen::Vector3f> points);

}  // namespace vestige
