#pragma once

#include "core/geometry/ViewCamera.h"

namespace vestige {

/// The camera with a parallel or a perspective projection. What lies at the depth of its focal point keeps
/// its place and size in the picture.
ViewCamera withProjection(const ViewCamera& camera, bool parallel);

/// The camera that shows, in a picture of another size, all that it shows now, centred, at the same scale
/// along the side that fits.
ViewCamera resized(const ViewCamera& camera, int width_px, int height_px);

}  // namespace vestige
