#pragma once

#include <QRectF>
#include <vector>

#include "ui/view/Marks.h"

namespace vestige {

/// Paints polylines, outlines and arcs: lines with a casing, corners of those with few points, a light fill
/// of closed ones. Returns their labels, each at its path's longest piece in the picture, to be placed with
/// the other marks.
std::vector<PaintedMark> paintPaths(QPainter& painter, const ViewTheme& theme, const QRectF& picture,
                                    const ViewCamera& camera, const std::vector<ViewPath>& paths);

}  // namespace vestige
