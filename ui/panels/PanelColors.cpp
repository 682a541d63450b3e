#include "ui/panels/PanelColors.h"

#include <QEvent>
#include <QPalette>
#include <QWidget>

namespace vestige {
namespace {

class PaletteWatch : public QObject {
  public:
    PaletteWatch(QWidget& widget, std::function<void()> reaction)
        : QObject(&widget), reaction_(std::move(reaction)) {}

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        // Once the widgets below it have the new palette, too.
        if (event->type() == QEvent::PaletteChange)
            QMetaObject::invokeMethod(
                this, [this] { reaction_(); }, Qt::QueuedConnection);
        return QObject::eventFilter(watched, event);
    }

  private:
    std::function<void()> reaction_;
};

}  // namespace

bool isLight(const QPalette& palette) {
    return palette.color(QPalette::Window).lightness() > 127;
}

QColor quietColor(const QPalette& palette) {
    return palette.color(QPalette::PlaceholderText);
}

QColor goodColor(const QPalette& palette) {
    return isLight(palette) ? QColor(0x1b, 0x70, 0x45) : QColor(0x8f, 0xd9, 0xae);
}

QColor aboveColor(const QPalette& palette) {
    return isLight(palette) ? QColor(0xa8, 0x4f, 0x00) : QColor(0xf2, 0xab, 0x5c);
}

QColor belowColor(const QPalette& palette) {
    return isLight(palette) ? QColor(0x17, 0x54, 0xb8) : QColor(0x8a, 0xb8, 0xff);
}

void onPaletteChange(QWidget& widget, std::function<void()> reaction) {
    widget.installEventFilter(new PaletteWatch(widget, std::move(reaction)));
}

}  // namespace vestige
