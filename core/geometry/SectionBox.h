#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/geometry/Picking.h"

namespace vestige {

/// An upright box that the scene is cut to: what lies outside is neither drawn nor picked. World, metres.
struct SectionBox {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    Eigen::Vector3d halfSize = Eigen::Vector3d::Ones();
    double heading_rad = 0;  ///< turns the box's x axis from world x towards world y

    /// Its six sides.
    std::vector<ClipPlane> planes() const;
    bool contains(const Eigen::Vector3d& world) const;
    friend bool operator==(const SectionBox&, const SectionBox&) = default;
};

}  // namespace vestige
