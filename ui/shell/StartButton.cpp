#include "ui/shell/StartButton.h"

#include <QAction>
#include <QFontMetrics>
#include <QPainter>

#include "ui/panels/PanelColors.h"
#include "ui/shell/StyleColors.h"

namespace vestige {
namespace {
constexpr int kIcon = 24;
constexpr int kMargin = 14;
constexpr int kHeight = 62;
}  // namespace

StartButton::StartButton(QAction& action, const QString& title, const QString& sentence, bool primary,
                         QWidget* parent)
    : QAbstractButton(parent), action_(action), sentence_(sentence), primary_(primary) {
    setText(title);
    setToolTip(action.toolTip());
    setAccessibleDescription(sentence);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(this, &QAbstractButton::clicked, &action, &QAction::trigger);
    const auto follow = [this] {
        setEnabled(action_.isEnabled());
        update();
    };
    connect(&action, &QAction::changed, this, follow);
    follow();
}

QSize StartButton::sizeHint() const {
    return {320, kHeight};
}

void StartButton::enterEvent(QEvent* event) {
    QAbstractButton::enterEvent(event);
    update();
}

void StartButton::leaveEvent(QEvent* event) {
    QAbstractButton::leaveEvent(event);
    update();
}

void StartButton::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF whole = QRectF(rect()).adjusted(0.75, 0.75, -0.75, -0.75);
    const bool over = isEnabled() && (underMouse() || isDown());
    const bool primary = primary_ && isEnabled();
    const Theme theme = isLight(palette()) ? Theme::light : Theme::dark;
    const QColor accent = styleColor("accent", theme);
    const QColor ground = palette().color(QPalette::Button);
    painter.setBrush(primary ? (over ? styleColor("accent-hover", theme) : accent)
                             : (over ? styleColor("hover", theme) : ground));
    painter.setPen(hasFocus() ? QPen(palette().color(QPalette::Link), 1.5)
                              : QPen(primary ? accent : palette().color(QPalette::Mid), 1));
    painter.drawRoundedRect(whole, 6, 6);
    const QIcon::State state = primary ? QIcon::On : QIcon::Off;
    const QRect icon(kMargin, (height() - kIcon) / 2, kIcon, kIcon);
    action_.icon().paint(&painter, icon, Qt::AlignCenter, isEnabled() ? QIcon::Normal : QIcon::Disabled,
                         state);
    const int left = kMargin + kIcon + 14;
    const int room = width() - left - kMargin;
    QFont title = font();
    title.setWeight(QFont::DemiBold);
    const QColor ink = primary       ? QColor(Qt::white)
                       : isEnabled() ? palette().color(QPalette::WindowText)
                                     : palette().color(QPalette::Disabled, QPalette::WindowText);
    painter.setPen(ink);
    painter.setFont(title);
    painter.drawText(QRect(left, 11, room, 20), Qt::AlignLeft | Qt::AlignVCenter, text());
    QFont small = font();
    small.setPixelSize(12);
    painter.setFont(small);
    painter.setPen(primary ? QColor(0xe6, 0xee, 0xfd) : quietColor(palette()));
    painter.drawText(QRect(left, 31, room, 20), Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetrics(small).elidedText(sentence_, Qt::ElideRight, room));
}

}  // namespace vestige
