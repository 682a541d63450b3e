#pragma once

#include <span>
#include <vector>

#include "core/geometry/Pose.h"
#include "core/registration/quality/SurfaceCells.h"

namespace vestige {

/// How a piece of one cloud's surface lies to the other cloud.
enum class SurfaceState {
    agrees,     ///< on a plane of the other, within the tolerance, and parallel to it
    conflicts,  ///< the other has surface here, but elsewhere or across
    vague,      ///< one of the two pieces here is thicker than the tolerance, and they are not that near
    unseen      ///< the other has nothing here
};

struct SurfaceMatch {
    std::uint32_t cell = 0;  ///< of the moved cloud
    const SurfaceCell* other = nullptr;
    Eigen::Vector3d place = Eigen::Vector3d::Zero();   ///< the cell's mean, moved
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< its own, moved
    double distance_m = 0;   ///< signed, of the place from the other's plane; of a compatible plane only
    double predicted_m = 0;  ///< standard deviation of that distance that noise alone explains
    SurfaceState state = SurfaceState::unseen;
};

/// Lays each cell of a cloud, moved by `pose`, on the surface of the other. `tolerance_m` bounds the distance
/// of those that agree.
std::vector<SurfaceMatch> matchSurfaces(const std::vector<SurfaceCell>& cells, const Pose& pose,
                                        const SurfaceIndex& other, double tolerance_m);

}  // namespace vestige
