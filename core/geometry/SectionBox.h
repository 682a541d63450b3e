#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/geometry/ClipRegion.h"
#include "core/geometry/Picking.h"

namespace vestige {

/// An upright box that the scene is cut to: what lies outside is neither drawn nor picked; inverted, what
/// lies inside. World, metres.
struct SectionBox {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    Eigen::Vector3d halfSize = Eigen::Vector3d::Ones();
    double heading_rad = 0;  ///< turns the box's x axis from world x towards world y
    bool inverted = false;   ///< the inside is cut away instead

    /// Its six sides.
    std::vector<ClipPlane> planes() const;
    /// What it leaves to be seen.
    ClipRegion region() const { return {planes(), inverted}; }
    /// In the box, whatever is cut away.
    bool contains(const Eigen::Vector3d& world) const;
    bool keeps(const Eigen::Vector3d& world) const { return contains(world) != inverted; }
    friend bool operator==(const SectionBox&, const SectionBox&) = default;
};

}  // namespace vestige
