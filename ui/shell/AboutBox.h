#pragma once

class QWidget;

namespace vestige {

/// Version, purpose and source of the method.
void showAbout(QWidget* window);

}  // namespace vestige
