#pragma once

#include "core/pipeline/ViewRenderer.h"
#include "ui/actions/Workbench.h"
#include "ui/shell/ViewBar.h"

class QCheckBox;
class QPushButton;

namespace vestige {

class SceneView;

/// What a picture of the view is saved as: its size, or its scale and dots per inch.
class PictureBar : public ViewBar {
    Q_OBJECT

  public:
    PictureBar(const Workbench& bench, SceneView& view, QWidget* parent = nullptr);

    /// The view as the picture that the fields ask for.
    ViewDescription described() const;

  private:
    void follow();
    void save();

    Workbench bench_;
    SceneView& view_;
    QDoubleSpinBox* width_;
    QDoubleSpinBox* height_;
    QCheckBox* toScale_;
    QDoubleSpinBox* scale_;
    QDoubleSpinBox* dpi_;
    QCheckBox* transparent_;
    QLabel* shows_;
};

}  // namespace vestige
