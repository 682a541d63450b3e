#pragma once

class QAction;
class QCheckBox;
class QPushButton;

namespace vestige {

/// Widgets of a panel that say and do what an action does, and are enabled and checked as it is.
QPushButton* buttonFor(QAction& action);
QCheckBox* checkBoxFor(QAction& action);

}  // namespace vestige
