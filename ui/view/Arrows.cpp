#include "ui/view/Arrows.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/view/Translated.h"
#include "ui/view/ViewTheme.h"

namespace vestige {
namespace {

constexpr double kHead_px = 13;

QPolygonF seenPath(const ViewCamera& camera, const std::vector<Eigen::Vector3d>& path) {
    QPolygonF line;
    for (const Eigen::Vector3d& point : path) {
        const auto seen = camera.project(point);
        if (seen) line << QPointF(seen->pixel.x(), seen->pixel.y());
    }
    return line;
}

/// A triangle whose tip is `tip`, pointing away from `from`.
QPolygonF head(const QPointF& tip, const QPointF& from) {
    const QPointF along = tip - from;
    const double length = std::hypot(along.x(), along.y());
    if (length < 1e-6) return {};
    const QPointF ahead = along / length;
    const QPointF aside(-ahead.y(), ahead.x());
    const QPointF foot = tip - kHead_px * ahead;
    return QPolygonF(QVector<QPointF>{tip, foot + 0.5 * kHead_px * aside, foot - 0.5 * kHead_px * aside});
}

bool isFree(const QRectF& place, const std::vector<QRectF>& taken) {
    return std::none_of(taken.begin(), taken.end(),
                        [&](const QRectF& other) { return other.intersects(place); });
}

void paintLabel(QPainter& painter, const ViewTheme& theme, const QRectF& picture, const QPolygonF& line,
                const QString& text, std::vector<QRectF>& taken) {
    painter.setFont(theme.font(12, true));
    const QSizeF size(painter.fontMetrics().horizontalAdvance(text) + 18, 24);
    const QRectF inside = picture.adjusted(4, 4, -4, -4);
    for (const QPointF& end : {line.last(), line.first(), line.at(line.size() / 2)})
        for (const double down : {14.0, -38.0, 46.0, -70.0, 80.0}) {
            QRectF place(end + QPointF(-0.5 * size.width(), down), size);
            place.moveLeft(std::clamp(place.left(), inside.left(),
                                      std::max(inside.left(), inside.right() - size.width())));
            if (!inside.contains(place) || !isFree(place, taken)) continue;
            painter.setPen(QPen(theme.highlight, 1));
            painter.setBrush(theme.panel);
            painter.drawRoundedRect(place, 5, 5);
            painter.setBrush(Qt::NoBrush);
            painter.setPen(theme.text);
            painter.drawText(place, Qt::AlignCenter, text);
            taken.push_back(place);
            return;
        }
}

}  // namespace

void paintArrow(QPainter& painter, const ViewTheme& theme, const QRectF& picture, const ViewCamera& camera,
                const ViewArrow& arrow, std::vector<QRectF>& taken) {
    const QPolygonF line = seenPath(camera, arrow.path);
    if (line.size() < 2 || !line.boundingRect().adjusted(-1, -1, 1, 1).intersects(picture)) return;
    const QPolygonF heads[] = {head(line.first(), line.at(1)), head(line.last(), line.at(line.size() - 2))};
    for (const auto& [color, width] : {std::pair(theme.casing, 7.0), std::pair(theme.highlight, 3.0)}) {
        painter.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(Qt::NoBrush);
        painter.drawPolyline(line);
        painter.setBrush(color);
        for (const QPolygonF& one : heads) painter.drawPolygon(one);
    }
    painter.setBrush(Qt::NoBrush);
    if (!arrow.label.empty()) paintLabel(painter, theme, picture, line, translated(arrow.label), taken);
}

}  // namespace vestige
