#pragma once

#include <QRectF>
#include <optional>

#include "core/geometry/ViewCamera.h"

namespace vestige {

/// A line of the world as a picture shows it, pixels. An end that is not shown was cut off.
struct SeenLine {
    QPointF a;
    QPointF b;
    bool aShown = true;
    bool bShown = true;
};

/// The part before the camera; nothing when there is none.
std::optional<SeenLine> seenLine(const ViewCamera& camera, Eigen::Vector3d a, Eigen::Vector3d b);

/// The part inside a box (Liang and Barsky); nothing when the line misses it.
std::optional<SeenLine> cropped(const SeenLine& whole, const QRectF& box);

}  // namespace vestige
