#pragma once

#include "core/pipeline/ViewRenderer.h"

namespace vestige {

/// Pixels that a metre of the scene takes in a picture to scale: dpi / 0.0254 / denominator.
double pixelsPerMetre(double denominator, double dpi);

/// The parallel camera at the scale 1:denominator; its picture's size stays.
ViewCamera atScale(ViewCamera camera, double denominator, double dpi);

/// At that scale with a picture that holds all that `view` shows in the camera's direction, with a margin of
/// a centimetre on paper.
ViewCamera holdingAllAtScale(const ViewDescription& view, ViewCamera camera, double denominator, double dpi);

}  // namespace vestige
