#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

namespace vestige {

/// The half space normal . x + distance >= 0 (world).
struct ClipPlane {
    Eigen::Vector3d normal;
    double distance;
    friend bool operator==(const ClipPlane&, const ClipPlane&) = default;
};

/// What a picture shows of the world: what lies in all of the half spaces (without any: everything), or,
/// inverted, what does not.
struct ClipRegion {
    std::vector<ClipPlane> planes;
    bool inverted = false;

    bool keeps(const Eigen::Vector3d& world) const {
        const bool inside = std::all_of(planes.begin(), planes.end(), [&](const ClipPlane& plane) {
            return plane.normal.dot(world) + plane.distance >= 0;
        });
        return inside != inverted;
    }
    friend bool operator==(const ClipRegion&, const ClipRegion&) = default;
};

/// How much of a box a region keeps.
enum class Kept { none, part, all };

/// Of the box `middle` +- `half` in a frame whose place is a similarity in the world. `slack` (m): what lies
/// so near to a plane counts as on both of its sides. It may answer `part` of a box that is none or all,
/// never the other way round.
inline Kept kept(const ClipRegion& region, const Eigen::Matrix3d& turnAndScale, const Eigen::Vector3d& origin,
                 const Eigen::Vector3d& middle, const Eigen::Vector3d& half, double slack = 0) {
    Kept inside = Kept::all;
    for (const ClipPlane& plane : region.planes) {
        const Eigen::Vector3d normal = turnAndScale.transpose() * plane.normal;
        const double at = normal.dot(middle) + plane.normal.dot(origin) + plane.distance;
        const double reach = normal.cwiseAbs().dot(half) + slack;
        if (at + reach < 0) {
            inside = Kept::none;
            break;
        }
        if (at - reach < 0) inside = Kept::part;
    }
    if (!region.inverted || inside == Kept::part) return inside;
    return inside == Kept::all ? Kept::none : Kept::all;
}

}  // namespace vestige
