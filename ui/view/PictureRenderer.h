#pragma once

#include <memory>

#include "core/pipeline/ViewRenderer.h"
#include "ui/view/GlContext.h"

namespace vestige {

/// Draws descriptions completely and the same on every run, into PNG files of the camera's size, on a context
/// from `contexts` (made with the first picture). Needs a QApplication while it lives.
std::unique_ptr<ViewRenderer> pictureRenderer(GlContextFactory contexts);

/// The desktop program's renderer, on the graphics driver.
std::unique_ptr<ViewRenderer> nativeRenderer();

}  // namespace vestige
