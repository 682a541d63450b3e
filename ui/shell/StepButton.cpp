#include "ui/shell/StepButton.h"

#include <QFontMetrics>
#include <QPainter>
#include <QPainterPath>

#include "ui/panels/PanelColors.h"
#include "ui/shell/StyleColors.h"

namespace vestige {
namespace {

constexpr int kBadge = 18;
constexpr int kMargin = 10;
constexpr int kGap = 8;
constexpr int kHeight = 30;
QColor themed(const QPalette& palette, const char* name) {
    return styleColor(QLatin1String(name), isLight(palette) ? Theme::light : Theme::dark);
}
/// Longer words are cut; the tool tip has all of them.
constexpr int kMostWords = 260;

}  // namespace

StepButton::StepButton(WayStep step, QWidget* parent) : QAbstractButton(parent) {
    facts_.step = step;
    setText(titleOf(step));
    setObjectName("step-" + QString::number(static_cast<int>(step)));
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

QString StepButton::words() const {
    return facts_.missing.isEmpty() ? QString() : facts_.missing.front();
}

void StepButton::setFacts(const StepFacts& facts) {
    facts_ = facts;
    QStringList said;
    for (const QString& missing : facts.missing) said << missing;
    if (said.isEmpty()) said << facts.summary;
    const QString state = facts.state == StepState::done       ? tr("done")
                          : facts.state == StepState::optional ? tr("optional")
                          : facts.state == StepState::open     ? tr("something is missing")
                                                               : tr("comes later");
    setAccessibleName(tr("Step %1, %2: %3").arg(static_cast<int>(facts.step) + 1).arg(text(), state));
    setAccessibleDescription(said.join("; "));
    setToolTip(text() + ": " + said.join("\n"));
    updateGeometry();
    update();
}

void StepButton::setShown(bool shown) {
    if (shown == shown_) return;
    shown_ = shown;
    update();
}

int StepButton::wordsLeft() const {
    return kMargin + kBadge + kGap + QFontMetrics(font()).horizontalAdvance(text()) + kGap;
}

QSize StepButton::minimumSizeHint() const {
    return {wordsLeft() - kGap + kMargin, kHeight};
}

QSize StepButton::sizeHint() const {
    if (words().isEmpty()) return minimumSizeHint();
    QFont small = font();
    small.setPixelSize(12);
    const int width = std::min(QFontMetrics(small).horizontalAdvance(words()) + 2, kMostWords);
    return {wordsLeft() + width + kMargin, kHeight};
}

void StepButton::enterEvent(QEvent* event) {
    QAbstractButton::enterEvent(event);
    update();
}

void StepButton::leaveEvent(QEvent* event) {
    QAbstractButton::leaveEvent(event);
    update();
}

void StepButton::paintBadge(QPainter& painter) const {
    const QRectF circle(kMargin, (height() - kBadge) / 2.0, kBadge, kBadge);
    const bool done = facts_.state == StepState::done;
    const QColor ground = themed(palette(), done ? "done" : shown_ ? "accent" : "rule");
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawEllipse(circle);
    if (done) {
        painter.setPen(QPen(goodColor(palette()), 1.7, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(Qt::NoBrush);
        QPainterPath check;
        check.moveTo(circle.left() + 5.2, circle.top() + 9.3);
        check.lineTo(circle.left() + 7.9, circle.top() + 12);
        check.lineTo(circle.left() + 12.8, circle.top() + 6.5);
        painter.drawPath(check);
        return;
    }
    QFont number = font();
    number.setPixelSize(11);
    number.setWeight(QFont::DemiBold);
    painter.setFont(number);
    painter.setPen(shown_ ? QColor(Qt::white) : palette().color(QPalette::WindowText));
    painter.drawText(circle, Qt::AlignCenter, QString::number(static_cast<int>(facts_.step) + 1));
}

void StepButton::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF whole = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    if (shown_ || underMouse() || isDown()) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(themed(palette(), shown_ ? "selected" : "hover"));
        painter.drawRoundedRect(whole, 5, 5);
    }
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Link), 1.4));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(whole, 5, 5);
    }
    paintBadge(painter);
    QFont title = font();
    if (shown_) title.setWeight(QFont::DemiBold);
    painter.setFont(title);
    const bool quiet = facts_.state == StepState::waiting || facts_.state == StepState::optional;
    painter.setPen(quiet && !shown_ ? quietColor(palette()) : palette().color(QPalette::WindowText));
    const int left = kMargin + kBadge + kGap;
    painter.drawText(QRect(left, 0, width() - left, height()), Qt::AlignLeft | Qt::AlignVCenter, text());
    const int room = width() - wordsLeft() - kMargin + 2;
    if (words().isEmpty() || room < 40) return;
    QFont small = font();
    small.setPixelSize(12);
    painter.setFont(small);
    painter.setPen(aboveColor(palette()));
    painter.drawText(QRect(wordsLeft(), 0, room, height()), Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetrics(small).elidedText(words(), Qt::ElideRight, room));
}

}  // namespace vestige
