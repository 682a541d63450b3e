#pragma once

#include <QRectF>
#include <QString>
#include <optional>
#include <vector>

#include "ui/view/ColorScale.h"
#include "ui/view/SectionFrame.h"

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
    bool legend = true;  ///< where several pictures have one legend, only one of them
    QString name = {};   ///< of one of several pictures: "Top"
    bool sectionHandles = false;
    std::optional<SectionHandle> held = std::nullopt;     ///< the handle that the mouse has
    std::optional<Eigen::Vector3d> pivot = std::nullopt;  ///< what the view turns about, where that was set
};

/// Paints title, legend, scale bar, grid, arrows and marks: the same in the window and in pictures.
void paintOverlay(QPainter& painter, const OverlayContent& content);

/// "Top" for a parallel camera that looks straight down, "Perspective", ..., "Parallel".
QString viewName(const ViewCamera& camera);

}  // namespace vestige
