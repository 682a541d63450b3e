#pragma once

#include <QRectF>

#include "core/geometry/ViewCamera.h"

class QPainter;

namespace vestige {

struct ViewTheme;

/// A compass needle lying on the ground, seen as the camera sees it, at the bottom right of `inside`: it
/// points along the world's y axis. Nothing where the ground is seen edge on. Returns
/// the place it takes.
QRectF paintNorthArrow(QPainter& painter, const ViewTheme& theme, const QRectF& inside,
                       const ViewCamera& camera);

}  // namespace vestige
