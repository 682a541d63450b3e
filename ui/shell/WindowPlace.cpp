#include "ui/shell/WindowPlace.h"

#include <QGuiApplication>
#include <QMainWindow>
#include <QScreen>
#include <QSettings>

namespace vestige {
namespace {
constexpr const char* kKey = "window/place";
}  // namespace

void placeWindow(QMainWindow& window) {
    if (window.restoreGeometry(QSettings().value(kKey).toByteArray())) {
        // The whole screen is asked for anew each time.
        window.setWindowState(window.windowState() & ~Qt::WindowFullScreen);
        return;
    }
    const QScreen* screen = QGuiApplication::primaryScreen();
    if (!screen) return;
    const QRect room = screen->availableGeometry();
    if (window.width() < room.width() && window.height() < room.height()) return;
    // Without a window manager nothing makes it as large as the screen.
    window.setGeometry(room);
    window.setWindowState(window.windowState() | Qt::WindowMaximized);
}

void keepPlace(const QMainWindow& window) {
    QSettings().setValue(kKey, window.saveGeometry());
}

}  // namespace vestige
