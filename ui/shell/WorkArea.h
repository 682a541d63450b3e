#pragma once

#include <QWidget>

#include "ui/actions/Workbench.h"

class QSplitter;
class QVBoxLayout;

namespace vestige {

class CleaningReactions;
class CleaningTools;
class SceneView;
class PartsPanel;
class ToolSwitch;
class ViewArea;

/// The middle of the window: case at the left, view with registration strip, measurements and alignment at
/// the right, the notice above.
class WorkArea : public QWidget {
    Q_OBJECT

  public:
    WorkArea(const Workbench& bench, SceneView& view, ToolSwitch& tools, QWidget* parent = nullptr);

    /// One more above the view.
    void addBar(QWidget* bar);
    /// Shows the hints of lasso and box, and lets the name of a new part be typed.
    void follow(CleaningTools& tools, CleaningReactions& reactions);

  signals:
    /// A recent file was chosen.
    void chosen(const QString& path);

  private:
    QWidget* makeLeft();
    QWidget* makeMiddle();
    QWidget* makeRight();

    Workbench bench_;
    SceneView& view_;
    ToolSwitch& tools_;
    QVBoxLayout* column_ = nullptr;
    ViewArea* area_ = nullptr;
    PartsPanel* parts_ = nullptr;
};

}  // namespace vestige
