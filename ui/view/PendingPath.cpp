#include "ui/view/PendingPath.h"

#include <QPainter>
#include <QPainterPath>

#include "ui/view/ViewTheme.h"

namespace vestige {

void paintPendingPath(QPainter& painter, const ViewTheme& theme, const ViewCamera& camera,
                      const std::vector<Eigen::Vector3d>& path) {
    if (path.empty()) return;
    QPainterPath line;
    std::vector<QPointF> places;
    bool joined = false;
    for (const Eigen::Vector3d& point : path) {
        const auto at = camera.project(point);
        const bool shown = at && (camera.parallel || at->depth_m > 0);
        if (shown) {
            const QPointF place(at->pixel.x(), at->pixel.y());
            joined ? line.lineTo(place) : line.moveTo(place);
            places.push_back(place);
        }
        joined = shown;
    }
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.casing, 4.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(line);
    painter.setPen(QPen(theme.highlight, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(line);
    painter.setPen(QPen(theme.casing, 1.5));
    painter.setBrush(theme.highlight);
    for (const QPointF& place : places) painter.drawEllipse(place, 4, 4);
    painter.restore();
}

}  // namespace vestige
