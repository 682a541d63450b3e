#pragma once

#include <QColor>
#include <functional>

class QPalette;
class QWidget;

namespace vestige {

/// Colours of words and marks in the panels, by the window's palette; their contrast to it is at least 4.5.
bool isLight(const QPalette& palette);
QColor quietColor(const QPalette& palette);
QColor goodColor(const QPalette& palette);
/// Above and below what was expected: told apart without red and green.
QColor aboveColor(const QPalette& palette);
QColor belowColor(const QPalette& palette);

/// Calls when the widget's palette has changed: colours that were taken from it are out of date.
void onPaletteChange(QWidget& widget, std::function<void()> reaction);

}  // namespace vestige
