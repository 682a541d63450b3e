#pragma once

#include "core/pipeline/ViewRenderer.h"

namespace vestige {

/// A camera of the named direction whose picture the visible layers fill. Unlike fitCamera of their bounds it
/// follows the points themselves: a few stray ones (0.2 % on each side) do not make the scene small.
ViewCamera frameView(const ViewDescription& view, NamedView direction, int width_px, int height_px);

}  // namespace vestige
