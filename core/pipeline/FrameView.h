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
/// Of a description with a section it is what lies in that.
ViewCamera frameView(const ViewDescription& view, NamedView direction, int width_px, int height_px);

/// The same for the direction, projection and size of a camera.
ViewCamera framed(const ViewDescription& view, const ViewCamera& from);

/// Width and height of what a camera sees of the subject layers, metres at its focal point's depth; without
/// the same few stray points.
Eigen::Vector2d extentSeen_m(const ViewDescription& view, const ViewCamera& camera);

}  // namespace vestige
