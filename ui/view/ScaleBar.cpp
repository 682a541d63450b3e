#include "ui/view/ScaleBar.h"

#include <QPainter>
#include <cmath>

#include "ui/view/Translated.h"
#include "ui/view/ViewTheme.h"

namespace vestige {
namespace {

constexpr double kPadding = 10;

}  // namespace

QString lengthInWords(double metres) {
    if (metres >= 1000) return QStringLiteral("%1 km").arg(metres / 1000, 0, 'g', 4);
    if (metres >= 1) return QStringLiteral("%1 m").arg(metres, 0, 'g', 4);
    if (metres >= 0.01) return QStringLiteral("%1 cm").arg(metres * 100, 0, 'g', 4);
    return QStringLiteral("%1 mm").arg(metres * 1000, 0, 'g', 4);
}

double scaleBarLength(double most_m) {
    const double power = std::pow(10, std::floor(std::log10(most_m)));
    for (const double step : {5.0, 2.0, 1.0})
        if (step * power <= most_m * (1 + 1e-9)) return step * power;
    return power;
}

QRectF paintScaleBar(QPainter& painter, const ViewTheme& theme, const QRectF& inside,
                     const ViewCamera& camera, const QStringList& notes) {
    const double depth = (camera.focalPoint - camera.position).dot(camera.direction());
    const double metresPerPixel = camera.metresPerPixel(depth);
    if (!(metresPerPixel > 0) || !std::isfinite(metresPerPixel)) return {};
    const double length = scaleBarLength(std::min(190.0, 0.3 * inside.width()) * metresPerPixel);
    const double width = length / metresPerPixel;
    painter.setFont(theme.font(11));
    QStringList words = notes;
    if (!camera.parallel) words.prepend(translated("at the view's centre"));
    const QString where = words.join(QStringLiteral("   "));
    const double whereWidth = where.isEmpty() ? 0 : painter.fontMetrics().horizontalAdvance(where) + 8;
    painter.setFont(theme.font(12, true));
    const QString text = lengthInWords(length);
    const double textWidth = painter.fontMetrics().horizontalAdvance(text);
    const double content = std::max(width, textWidth + whereWidth);
    const QRectF panel(inside.left(), inside.bottom() - 40, content + 2 * kPadding, 40);
    painter.setPen(QPen(theme.panelEdge, 1));
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(panel.adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
    painter.setBrush(Qt::NoBrush);

    const QRectF textPlace(panel.left() + kPadding, panel.top() + 6, textWidth + 2, 16);
    painter.setPen(theme.text);
    painter.drawText(textPlace, Qt::AlignLeft | Qt::AlignVCenter, text);
    painter.setFont(theme.font(11));
    painter.setPen(theme.quietText);
    painter.drawText(QRectF(textPlace.right() + 6, textPlace.top(), whereWidth, 16),
                     Qt::AlignLeft | Qt::AlignVCenter, where);

    const QPointF left(panel.left() + kPadding, panel.bottom() - 8.5);
    const QPointF right(left.x() + width, left.y());
    const QPointF rise(0, -6);
    painter.setPen(QPen(theme.text, 1.6, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    painter.drawPolyline(QPolygonF(QVector<QPointF>{left + rise, left, right, right + rise}));
    return panel;
}

}  // namespace vestige
