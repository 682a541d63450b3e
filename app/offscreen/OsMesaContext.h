#pragma once

#include <memory>

#include "ui/view/GlContext.h"

namespace vestige {

/// A software OpenGL 3.2 core context that needs no display and no graphics driver; null when OSMesa refuses.
std::unique_ptr<GlContext> osMesaContext();

}  // namespace vestige
