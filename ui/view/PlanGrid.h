#pragma once

#include <QRectF>
#include <vector>

#include "core/geometry/ViewCamera.h"

class QPainter;

namespace vestige {

struct ViewTheme;

/// Spacing of a grid's lines, metres: the smallest of 1, 2, 5 times a power of ten that takes 64 pixels or
/// more where the camera looks.
double gridSpacing_m(const ViewCamera& camera);

/// Whether a picture's right and up run along axes of the world, so that grid lines are upright and level
/// and can carry coordinates.
bool showsPlan(const ViewCamera& camera);

/// The grid of such a picture, over its points, with coordinates in metres at its lower and right edge where
/// `taken` leaves room. Returns the places of the coordinates.
std::vector<QRectF> paintPlanGrid(QPainter& painter, const ViewTheme& theme, const QRectF& picture,
                                  const ViewCamera& camera, const std::vector<QRectF>& taken);

}  // namespace vestige
