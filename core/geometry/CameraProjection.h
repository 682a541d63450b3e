#pragma once

#include "core/geometry/ViewCamera.h"

namespace vestige {

/// The camera with a parallel or a perspective projection. What lies at the depth of its focal point keeps
/// its place and size in the picture.
ViewCamera withProjection(const ViewCamera& camera, bool parallel);

/// The camera that shows below a strip of so many pixels what `camera` shows in its picture, at the same
/// scale.
ViewCamera withRoomAbove(const ViewCamera& camera, int strip_px);

/// The camera that shows, in a picture of another size, all that it shows now, centred, at the same scale
/// along the side that fits.
ViewCamera resized(const ViewCamera& camera, int width_px, int height_px);

}  // namespace vestige
