#include "core/geometry/SectionBox.h"

#include <cmath>

namespace vestige {
namespace {

/// The box's axes in the world, as columns.
Eigen::Matrix3d axesOf(const SectionBox& box) {
    const double c = std::cos(box.heading_rad);
    const double s = std::sin(box.heading_rad);
    Eigen::Matrix3d axes;
    axes << c, -s, 0, s, c, 0, 0, 0, 1;
    return axes;
}

}  // namespace

std::vector<ClipPlane> SectionBox::planes() const {
    const Eigen::Matrix3d axes = axesOf(*this);
    std::vector<ClipPlane> sides;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {1.0, -1.0}) {
            const Eigen::Vector3d inward = side * axes.col(axis);
            sides.push_back({inward, halfSize[axis] - inward.dot(centre)});
        }
    }
    return sides;
}

bool SectionBox::contains(const Eigen::Vector3d& world) const {
    const Eigen::Vector3d inBox = axesOf(*this).transpose() * (world - centre);
    return (inBox.array().abs() <= halfSize.array()).all();
}

}  // namespace vestige
