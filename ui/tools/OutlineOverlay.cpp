#include "ui/tools/OutlineOverlay.h"

#include <QPainter>
#include <QPolygon>

namespace vestige {

OutlineOverlay::OutlineOverlay(QWidget* view) : QWidget(view) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setGeometry(view->rect());
    raise();
    QWidget::show();
}

void OutlineOverlay::show(std::vector<QPoint> corners, std::size_t marked) {
    corners_ = std::move(corners);
    marked_ = marked;
    setGeometry(parentWidget()->rect());
    update();
}

void OutlineOverlay::paintEvent(QPaintEvent*) {
    if (corners_.empty()) return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QPolygon polygon;
    for (const QPoint& corner : corners_) polygon << corner;
    // A dark line under a light one is seen on any ground.
    painter.setBrush(QColor(255, 72, 196, 36));
    painter.setPen(Qt::NoPen);
    painter.drawPolygon(polygon);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 150), 3.5));
    painter.drawPolyline(polygon);
    painter.setPen(QPen(QColor(255, 72, 196), 1.7));
    painter.drawPolyline(polygon);
    painter.setPen(QPen(QColor(255, 72, 196), 1.2, Qt::DashLine));
    painter.drawLine(polygon.last(), polygon.first());
    painter.setPen(QPen(QColor(0, 0, 0, 150), 1));
    painter.setBrush(Qt::white);
    for (std::size_t i = 0; i < marked_ && i < corners_.size(); ++i)
        painter.drawEllipse(QPointF(corners_[i]), i == 0 ? 4.5 : 3, i == 0 ? 4.5 : 3);
}

}  // namespace vestige
