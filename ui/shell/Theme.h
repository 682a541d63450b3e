#pragma once

namespace vestige {

/// Dark colours, Inter where it is installed, and the style sheet; once per program, needs the QApplication.
void applyTheme();

}  // namespace vestige
