#pragma once

#include <QRectF>
#include <optional>
#include <vector>

#include "ui/view/ColorScale.h"

class QPainter;

namespace vestige {

/// What is painted over the 3D picture.
struct OverlayContent {
    const ViewDescription& view;
    const ViewCamera& camera;  ///< with the size of the picture
    const std::optional<ColorScale>& scale;
    const std::optional<ViewMark>& pending;  ///< a pair in the making
    /// What stands over the picture: legend, labels and marks' words keep clear of it.
    std::vector<QRectF> covered = {};
};

/// Paints title, legend, scale bar and marks: the same in the window and in pictures.
void paintOverlay(QPainter& painter, const OverlayContent& content);

}  // namespace vestige
