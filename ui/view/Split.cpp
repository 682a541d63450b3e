#include "ui/view/Split.h"

#include <QPainter>

#include "ui/view/Translated.h"
#include "ui/view/ViewTheme.h"

namespace vestige {
namespace {

constexpr double kNameHeight = 28;
constexpr double kAboveFoot = 64;  // clear of the scale bar

double widthOf(const QPainter& painter, const QString& text) {
    return painter.fontMetrics().horizontalAdvance(text) + 24;
}

QRectF paintName(QPainter& painter, const ViewTheme& theme, const QRectF& place, const QString& name) {
    painter.setPen(QPen(theme.panelEdge, 1));
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(place.adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(theme.text);
    painter.drawText(place, Qt::AlignCenter, name);
    return place;
}

QRectF paintDivider(QPainter& painter, const ViewTheme& theme, const QRectF& picture,
                    const ViewComparison& comparison, const QString& name, const QString& other) {
    const double x = picture.left() + comparison.divider * picture.width();
    painter.setPen(QPen(theme.casing, 4));
    painter.drawLine(QPointF(x, picture.top()), QPointF(x, picture.bottom()));
    painter.setPen(QPen(theme.line, 1.6));
    painter.drawLine(QPointF(x, picture.top()), QPointF(x, picture.bottom()));
    const QPointF handle(x, picture.center().y());
    painter.setBrush(theme.panel);
    painter.drawEllipse(handle, 15, 15);
    painter.setBrush(Qt::NoBrush);
    for (const double side : {-1.0, 1.0}) {
        const QPointF tip = handle + QPointF(side * 9, 0);
        painter.drawPolyline(
            QPolygonF(QVector<QPointF>{tip + QPointF(-side * 5, -5), tip, tip + QPointF(-side * 5, 5)}));
    }
    const double top = picture.bottom() - kAboveFoot - kNameHeight;
    const QRectF left(x - 8 - widthOf(painter, other), top, widthOf(painter, other), kNameHeight);
    const QRectF right(x + 8, top, widthOf(painter, name), kNameHeight);
    paintName(painter, theme, left, other);
    paintName(painter, theme, right, name);
    return left | right;
}

/// Small crosses where four tiles meet: lines along the tiles would hide what runs across them.
void paintCorners(QPainter& painter, const ViewTheme& theme, const QRectF& picture, int tile_px) {
    constexpr double kArm = 4;
    for (const auto& [color, width] : {std::pair(theme.casing, 3.0), std::pair(theme.line, 1.2)}) {
        painter.setPen(QPen(color, width));
        for (double x = picture.left() + tile_px; x < picture.right(); x += tile_px)
            for (double y = picture.top() + tile_px; y < picture.bottom(); y += tile_px) {
                painter.drawLine(QPointF(x - kArm, y), QPointF(x + kArm, y));
                painter.drawLine(QPointF(x, y - kArm), QPointF(x, y + kArm));
            }
    }
}

}  // namespace

QRectF paintSplit(QPainter& painter, const ViewTheme& theme, const QRectF& picture,
                  const ViewComparison& comparison) {
    const QString name = QString::fromStdString(comparison.name);
    const QString other = QString::fromStdString(comparison.otherName);
    painter.setFont(theme.font(13, true));
    if (comparison.mode == CompareMode::swipe)
        return paintDivider(painter, theme, picture, comparison, name, other);
    QString said = comparison.otherShown ? other : name;
    if (comparison.mode == CompareMode::checkerboard) {
        paintCorners(painter, theme, picture, comparison.tile_px);
        said = translated("Tiles: %1 and %2 in turn, %1 at the top left; faint where a tile's own is empty")
                   .arg(name, other);
    }
    const double width = comparison.mode == CompareMode::checkerboard
                             ? widthOf(painter, said)
                             : std::max(widthOf(painter, name), widthOf(painter, other));
    return paintName(
        painter, theme,
        {picture.center().x() - 0.5 * width, picture.bottom() - kAboveFoot - kNameHeight, width, kNameHeight},
        said);
}

}  // namespace vestige
