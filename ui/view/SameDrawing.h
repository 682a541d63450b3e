#pragma once

#include "core/pipeline/ViewRenderer.h"

namespace vestige {

/// Whether both descriptions draw the same points, meshes and background from any camera: everything but the
/// camera and what is painted over the picture (marks, paths, arrows, title, legend, scale bar). A new field of
/// ViewDescription that is drawn with the points belongs here.
bool sameDrawing(const ViewDescription& a, const ViewDescription& b);

}  // namespace vestige
