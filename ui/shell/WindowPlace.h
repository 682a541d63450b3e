#pragma once

class QMainWindow;

namespace vestige {

/// Puts the window where it was closed the last time; at first, and where that screen is gone, at its own
/// size, or over all of a screen that is smaller. Before it is shown.
void placeWindow(QMainWindow& window);
/// Keeps where the window is for the next start.
void keepPlace(const QMainWindow& window);

}  // namespace vestige
