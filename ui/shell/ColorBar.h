#pragma once

#include "ui/shell/ViewBar.h"

class QComboBox;

namespace vestige {

class ActionCatalog;
class Presentation;
class SceneView;

/// The colour map and from where to where it runs, of what the colours show now.
class ColorBar : public ViewBar {
    Q_OBJECT

  public:
    ColorBar(ActionCatalog& actions, Presentation& presentation, const SceneView& view,
             QWidget* parent = nullptr);

  private:
    void follow();
    void takeEnds();
    void takeCut();

    Presentation& presentation_;
    const SceneView& view_;
    QComboBox* map_;
    QDoubleSpinBox* low_;
    QDoubleSpinBox* high_;
    QDoubleSpinBox* cut_;
    QLabel* what_;
    QLabel* none_;
};

}  // namespace vestige
