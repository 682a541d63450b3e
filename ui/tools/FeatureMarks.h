#pragma once

#include "core/geometry/ViewCamera.h"
#include "ui/tools/ProbedPlace.h"

class QPainter;

namespace vestige {

struct ViewTheme;

/// Paints what a pick is snapped to over the picture: a patch of the plane, the edge's line, the circle, the
/// place of the others; and a dotted line to it from the measured point. Nothing for a pick without a
/// feature.
void paintFeature(QPainter& painter, const ViewTheme& theme, const ViewCamera& camera,
                  const ProbedPick& pick);

}  // namespace vestige
