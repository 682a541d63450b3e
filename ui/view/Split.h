#pragma once

#include <QRectF>

#include "core/pipeline/ViewRenderer.h"

class QPainter;

namespace vestige {

struct ViewTheme;

/// Paints what tells the two pictures of a comparison apart: the divider with its handle and a name at either
/// side; the corners of the tiles; the name of the picture that blinks up now. Returns the place of the
/// names.
QRectF paintSplit(QPainter& painter, const ViewTheme& theme, const QRectF& picture,
                  const ViewComparison& comparison);

}  // namespace vestige
