#pragma once

#include <array>

#include "ui/shell/ViewBar.h"

namespace vestige {

class ActionCatalog;
class Presentation;

/// The figures of the section box, and buttons for slabs.
class SectionBar : public ViewBar {
    Q_OBJECT

  public:
    SectionBar(ActionCatalog& actions, Presentation& presentation, QWidget* parent = nullptr);

  private:
    void follow();
    void take();

    Presentation& presentation_;
    std::array<QDoubleSpinBox*, 3> middle_{};
    std::array<QDoubleSpinBox*, 3> size_{};
    QDoubleSpinBox* turn_;
};

}  // namespace vestige
