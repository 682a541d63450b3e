#pragma once

#include <memory>

#include "core/pipeline/ViewRenderer.h"
#include "ui/view/GlContext.h"

namespace vestige {

/// The longest side that a picture may have, and its most pixels: what painting and memory bear.
constexpr int kLargestSide_px = 32000;
constexpr long kMostPixels = 268000000;

/// Draws descriptions completely and the same on every run, into PNG files of the camera's size, on a context
/// from `contexts` (made with the first picture). What is larger than `tile_px` a side is drawn in parts:
/// graphics cards draw no more at once. Needs a QApplication while it lives.
std::unique_ptr<ViewRenderer> pictureRenderer(GlContextFactory contexts, int tile_px = 4096);

/// The desktop program's renderer, on the graphics driver.
std::unique_ptr<ViewRenderer> nativeRenderer();

}  // namespace vestige
