#pragma once

#include <Eigen/Core>
#include <cmath>

namespace vestige {

/// The grid on which a file holds its coordinates, world = steps * scale + offset with whole steps, as in
/// LAS. A cloud that knows it gives back its points exactly, though it holds float offsets only.
struct CoordinateGrid {
    Eigen::Vector3d scale = Eigen::Vector3d::Ones();
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();

    /// The grid's place nearest to `world`.
    Eigen::Vector3d snapped(const Eigen::Vector3d& world) const {
        Eigen::Vector3d place;
        for (int axis = 0; axis < 3; ++axis)
            place[axis] =
                std::nearbyint((world[axis] - offset[axis]) / scale[axis]) * scale[axis] + offset[axis];
        return place;
    }

    /// True when a place of the grid can be told from its float offset round an origin: the float's rounding
    /// at `farthest` (largest offset of a coordinate, per axis) stays below 0.45 steps.
    bool heldByFloats(const Eigen::Vector3f& farthest) const {
        for (int axis = 0; axis < 3; ++axis) {
            const float next = std::nextafter(farthest[axis], 2 * farthest[axis] + 1);
            const double rounding = 0.5 * (static_cast<double>(next) - static_cast<double>(farthest[axis]));
            // Doubles round too: at most some of their last bits at the coordinate's own magnitude.
            const double coordinate = std::abs(offset[axis]) + static_cast<double>(farthest[axis]);
            if (!(rounding + 4e-16 * coordinate < 0.45 * std::abs(scale[axis]))) return false;
        }
        return true;
    }
};

}  // namespace vestige
