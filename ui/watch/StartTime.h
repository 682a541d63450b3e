#pragma once

#include <QObject>
#include <functional>

class QWidget;

namespace vestige {

/// Seconds since the system started this process, to 10 ms (/proc/self/stat); negative where it cannot tell.
double processAge_s();

/// Calls `usable` once, when the window is on the screen, painted, and the event loop has nothing left to do.
void whenUsable(QWidget& window, std::function<void()> usable);

}  // namespace vestige
