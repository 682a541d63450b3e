#pragma once

#include <QRectF>

#include "core/geometry/ViewCamera.h"

class QPainter;

namespace vestige {

struct ViewTheme;

/// A bar of 1, 2 or 5 times a power of ten metres at the bottom left of `inside`; in perspective it holds at
/// the depth of the camera's focal point, and says so. Returns the place it takes.
QRectF paintScaleBar(QPainter& painter, const ViewTheme& theme, const QRectF& inside,
                     const ViewCamera& camera);

/// The bar's length: the largest of 1, 2, 5 times a power of ten metres that is at most `most_m`.
double scaleBarLength(double most_m);

}  // namespace vestige
