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

/// The lines of such a picture's grid, over its points.
void paintPlanGrid(QPainter& painter, const ViewTheme& theme, const QRectF& picture,
                   const ViewCamera& camera);

/// Their coordinates in metres, at the lower and right edge where `taken` leaves room. Returns their places.
std::vector<QRectF> paintPlanCoordinates(QPainter& painter, const ViewTheme& theme, const QRectF& picture,
                                         const ViewCamera& camera, const std::vector<QRectF>& taken);

}  // namespace vestige
