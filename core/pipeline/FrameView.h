#pragma once

#include "core/pipeline/ViewRenderer.h"

namespace vestige {

/// The visible layers that make up the scene: the target (else the first one) and what lies near it. A scan
/// that is not registered yet may stand in a frame of its own, hundreds of kilometres away. Indices into
/// view.layers.
std::vector<std::size_t> subjectLayers(const ViewDescription& view);

/// World bounds of those.
BoundingBox subjectBounds(const ViewDescription& view);

/// A camera of the named direction whose picture the subject layers fill. Unlike fitCamera of their bounds it
/// follows the points themselves: a few stray ones (0.2 % on each side) do not make the scene small.
ViewCamera frameView(const ViewDescription& view, NamedView direction, int width_px, int height_px);

}  // namespace vestige
