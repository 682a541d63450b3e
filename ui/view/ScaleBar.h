#pragma once

#include <QRectF>
#include <QStringList>

#include "core/geometry/ViewCamera.h"

class QPainter;

namespace vestige {

struct ViewTheme;

/// A bar of 1, 2 or 5 times a power of ten metres at the bottom left of `inside`; in perspective it holds at
/// the depth of the camera's focal point, and says so. `notes` stand beside it. Returns the place it takes.
QRectF paintScaleBar(QPainter& painter, const ViewTheme& theme, const QRectF& inside,
                     const ViewCamera& camera, const QStringList& notes = {});

/// "2 m", "5 cm", "1 km".
QString lengthInWords(double metres);

/// The bar's length: the largest of 1, 2, 5 times a power of ten metres that is at most `most_m`.
double scaleBarLength(double most_m);

}  // namespace vestige
