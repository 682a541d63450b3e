#pragma once

#include "ui/view/GlContext.h"
#include "ui/view/ViewSurface.h"

namespace vestige {

/// Surfaces for programs without a display: a plain widget that paints the frames of a context from
/// `contexts`.
ViewSurfaceFactory paintedSurface(GlContextFactory contexts);

}  // namespace vestige
