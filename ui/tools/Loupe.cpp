#include "ui/tools/Loupe.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>

namespace vestige {
namespace {

constexpr int kCaptionHeight_px = 23;
constexpr int kGap_px = 6;
constexpr int kEdge_px = 2;
constexpr int kWidest_px = 300;
/// Of its circle from the cursor.
constexpr int kAside_px = 30;

}  // namespace

Loupe::Loupe(QWidget* view) : QWidget(view) {
    setObjectName("loupe");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    setAccessibleName(tr("Loupe"));
    hide();
}

void Loupe::show(const QImage& picture, const QString& caption, bool taken, const ViewTheme& theme) {
    picture_ = picture;
    theme_ = theme;
    taken_ = taken;
    const QFontMetricsF metrics(theme_.font(12));
    caption_ = metrics.elidedText(caption, Qt::ElideRight, kWidest_px - 20);
    setAccessibleDescription(caption);
    const int words = static_cast<int>(std::ceil(metrics.horizontalAdvance(caption_))) + 20;
    resize(std::max(kDiameter_px + 2 * kEdge_px, words + 2),
           kDiameter_px + 2 * kEdge_px + kGap_px + kCaptionHeight_px + 1);
    setVisible(true);
    update();
}

void Loupe::placeBeside(const QPoint& cursor, const std::vector<QRectF>& covered) {
    const int side = (width() + kDiameter_px) / 2;
    const QRectF room = QRectF(parentWidget()->rect()).adjusted(4, 4, -4, -4);
    const std::array<QPoint, 4> wishes{cursor + QPoint(-kAside_px - side, kAside_px),
                                       cursor + QPoint(kAside_px - (width() - side), kAside_px),
                                       cursor + QPoint(-kAside_px - side, -kAside_px - height()),
                                       cursor + QPoint(kAside_px - (width() - side), -kAside_px - height())};
    const auto free = [&](const QPoint& at) {
        const QRectF box(at, size());
        return room.contains(box) && std::none_of(covered.begin(), covered.end(),
                                                  [&](const QRectF& cover) { return cover.intersects(box); });
    };
    const auto* found = std::find_if(wishes.begin(), wishes.end(), free);
    QPoint at = found == wishes.end() ? wishes[0] : *found;
    if (found == wishes.end()) {
        // In a small view, at least inside of it and not over the cursor.
        if (at.x() < room.left()) at.setX(cursor.x() + kAside_px);
        if (at.y() + height() > room.bottom()) at.setY(cursor.y() - kAside_px - height());
    }
    move(at);
    raise();
}

QRectF Loupe::captionBox() const {
    const double words = QFontMetricsF(theme_.font(12)).horizontalAdvance(caption_) + 18;
    return {0.5 * (width() - words), double(kDiameter_px + 2 * kEdge_px + kGap_px), words,
            double(kCaptionHeight_px)};
}

void Loupe::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    const QRectF circle(0.5 * (width() - kDiameter_px), kEdge_px, kDiameter_px, kDiameter_px);
    const QPointF middle = circle.center();
    QPainterPath round;
    round.addEllipse(circle);
    painter.save();
    painter.setClipPath(round);
    painter.drawImage(circle, picture_);
    // Casing first: the lines must be seen on points of any colour. The middle stays free for the point.
    QColor line = theme_.line;
    line.setAlpha(taken_ ? 235 : 110);
    constexpr double kFree_px = 7;
    for (const auto& [color, width] : {std::pair(theme_.casing, 3.2), std::pair(line, 1.2)}) {
        painter.setPen(QPen(color, width));
        for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
            painter.drawLine(middle + kFree_px * way, middle + kDiameter_px * way);
        if (taken_) painter.drawEllipse(middle, kFree_px, kFree_px);
    }
    painter.restore();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme_.casing, 4));
    painter.drawEllipse(circle);
    painter.setPen(QPen(taken_ ? theme_.text : theme_.quietText, 1.8));
    painter.drawEllipse(circle);

    const QRectF box = captionBox();
    painter.setPen(QPen(theme_.panelEdge, 1));
    painter.setBrush(theme_.panel);
    painter.drawRoundedRect(box, 5, 5);
    painter.setFont(theme_.font(12));
    painter.setPen(taken_ ? theme_.text : theme_.quietText);
    painter.drawText(box, Qt::AlignCenter, caption_);
}

}  // namespace vestige
