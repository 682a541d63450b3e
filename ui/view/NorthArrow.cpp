#include "ui/view/NorthArrow.h"

#include <Eigen/Geometry>
#include <QPainter>
#include <cmath>

#include "ui/view/ViewTheme.h"

namespace vestige {
namespace {

constexpr double kSide = 58;
constexpr double kRadius = 17;
constexpr double kLeastSeen = 0.14;

}  // namespace

QRectF paintNorthArrow(QPainter& painter, const ViewTheme& theme, const QRectF& inside,
                       const ViewCamera& camera) {
    const Eigen::Vector3d forward = camera.direction();
    const Eigen::Vector3d right = forward.cross(camera.viewUp).normalized();
    const Eigen::Vector3d up = right.cross(forward);
    const auto seen = [&](double x, double y) {
        return QPointF(right.x() * x + right.y() * y, -(up.x() * x + up.y() * y));
    };
    const QPointF north = seen(0, 1);
    if (std::abs(forward.z()) < kLeastSeen) return {};
    const QRectF panel(inside.right() - kSide, inside.bottom() - kSide, kSide, kSide);
    painter.setPen(QPen(theme.panelEdge, 1));
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(panel.adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
    const QPointF centre = panel.center();
    const auto at = [&](double x, double y) { return centre + QPointF(0, 2) + kRadius * seen(x, y); };
    const auto needle = [&](double tip) {
        return QPolygonF(QVector<QPointF>{at(0, tip), at(0.3, 0), at(-0.3, 0)});
    };
    painter.setPen(QPen(theme.quietText, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(needle(-1));
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.highlight);
    painter.drawPolygon(needle(1));
    painter.setBrush(Qt::NoBrush);
    const double length = std::hypot(north.x(), north.y());
    const QPointF letter = at(0, 1) + 7.5 * north / length;
    painter.setFont(theme.font(11, true));
    painter.setPen(theme.text);
    painter.drawText(QRectF(letter.x() - 10, letter.y() - 8, 20, 16), Qt::AlignCenter, QStringLiteral("N"));
    return panel;
}

}  // namespace vestige
