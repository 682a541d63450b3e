#include "ui/view/ScaleBar.h"

#include <QPainter>
#include <cmath>

#include "ui/view/ViewTheme.h"

namespace vestige {
namespace {

QString lengthText(double metres) {
    if (metres >= 1000) return QStringLiteral("%1 km").arg(metres / 1000, 0, 'g', 4);
    if (metres >= 1) return QStringLiteral("%1 m").arg(metres, 0, 'g', 4);
    if (metres >= 0.01) return QStringLiteral("%1 cm").arg(metres * 100, 0, 'g', 4);
    return QStringLiteral("%1 mm").arg(metres * 1000, 0, 'g', 4);
}

}  // namespace

double scaleBarLength(double most_m) {
    const double power = std::pow(10, std::floor(std::log10(most_m)));
    for (const double step : {5.0, 2.0, 1.0})
        if (step * power <= most_m * (1 + 1e-9)) return step * power;
    return power;
}

QRectF paintScaleBar(QPainter& painter, const ViewTheme& theme, const QRectF& inside,
                     const ViewCamera& camera) {
    const double depth = (camera.focalPoint - camera.position).dot(camera.direction());
    const double metresPerPixel = camera.metresPerPixel(depth);
    if (!(metresPerPixel > 0) || !std::isfinite(metresPerPixel)) return {};
    const double length = scaleBarLength(std::min(190.0, 0.3 * inside.width()) * metresPerPixel);
    const double width = length / metresPerPixel;
    const QPointF left(inside.left() + 2, inside.bottom() - 4);
    const QPointF right(left.x() + width, left.y());
    const QPointF rise(0, -6);
    const QPolygonF bar(QVector<QPointF>{left + rise, left, right, right + rise});
    painter.setPen(QPen(theme.casing, 4, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.drawPolyline(bar);
    painter.setPen(QPen(theme.text, 1.6, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.drawPolyline(bar);

    painter.setFont(theme.font(12, true));
    const QString text = lengthText(length);
    const QRectF textPlace(left.x() + 1, left.y() - 25, painter.fontMetrics().horizontalAdvance(text) + 2,
                           16);
    const auto write = [&](const QRectF& place, const QColor& color, const QString& words) {
        painter.setPen(theme.casing);
        painter.drawText(place.translated(1, 1), Qt::AlignLeft | Qt::AlignVCenter, words);
        painter.setPen(color);
        painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter, words);
    };
    write(textPlace, theme.text, text);
    double reach = width;
    if (!camera.parallel) {
        painter.setFont(theme.font(11));
        const QString where = QStringLiteral("at the view's centre");
        const QRectF wherePlace(textPlace.right() + 6, textPlace.top(),
                                painter.fontMetrics().horizontalAdvance(where) + 2, 16);
        write(wherePlace, theme.quietText.lighter(125), where);
        reach = std::max(reach, wherePlace.right() - left.x());
    }
    return {left.x(), left.y() - 26, reach, 30};
}

}  // namespace vestige
