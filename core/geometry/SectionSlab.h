#pragma once

#include <optional>

#include "core/geometry/BoundingBox.h"
#include "core/geometry/SectionBox.h"
#include "core/geometry/ViewCamera.h"

namespace vestige {

/// Which way a slab is thin: along a world axis, or along the view: upright and facing the camera, from above
/// level.
enum class SlabAxis { x, y, z, view };

/// A box of that thickness (m) across the axis which holds all of `scene` along it, at the middle of `scene`.
SectionBox slab(const BoundingBox& scene, SlabAxis axis, double thickness_m, const ViewCamera& camera);

/// The box's thinnest axis, 0 to 2 for its x, y, z: the one that a slab is moved along.
int thinAxis(const SectionBox& box);

/// Moved along one of its own axes, metres.
SectionBox moved(const SectionBox& box, int axis, double by_m);

/// One face moved outwards (below zero: inwards) by `by_m`, the opposite one staying. `side` is 1 or -1.
/// Never thinner than a millimetre.
SectionBox withFaceMoved(const SectionBox& box, int axis, int side, double by_m);

/// The box's axis in the world, unit length.
Eigen::Vector3d axisOf(const SectionBox& box, int axis);

/// A box round `scene`, a little larger.
SectionBox sectionRound(const BoundingBox& scene);

}  // namespace vestige
