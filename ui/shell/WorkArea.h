#pragma once

#include <QWidget>

#include "ui/actions/Workbench.h"

class QStackedWidget;
class QVBoxLayout;

namespace vestige {

class AccuracyPanel;
class CleaningReactions;
class CleaningTools;
class SceneView;
class StepBar;
class StepTabs;
class ToolSwitch;
class ViewArea;
class ViewsPanel;
class PartsPanel;
class ToolSwitch;
class ViewArea;

/// The middle of the window: the steps above, the case at the left, the view with the registration strip, the
/// panels of the step at the right.
class WorkArea : public QWidget {
    Q_OBJECT

  public:
    WorkArea(const Workbench& bench, SceneView& view, ToolSwitch& tools, QWidget* parent = nullptr);

    /// One more above the view.
    void addBar(QWidget* bar);
    /// Shows the hints of lasso and box, and lets the name of a new part be typed.
    void follow(CleaningTools& tools, CleaningReactions& reactions);

    ViewArea& viewArea() { return *viewArea_; }
    ViewsPanel& viewsPanel() { return *viewsPanel_; }

  signals:
    /// A recent file was chosen.
    void chosen(const QString& path);

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void showLeft();
    QWidget* makeLeft();
    QWidget* makeMiddle();
    QWidget* makeRight();
    /// The start page has the window to itself.
    void follow();

    Workbench bench_;
    SceneView& view_;
    ToolSwitch& tools_;
    QVBoxLayout* column_ = nullptr;
    StepBar* steps_ = nullptr;
    StepTabs* tabs_ = nullptr;
    QWidget* left_ = nullptr;
    QWidget* strip_ = nullptr;
    QStackedWidget* empty_ = nullptr;
    bool begun_ = false;     ///< a case, though it may be empty yet
    bool arriving_ = false;  ///< a case was opened, and none of its scans is there yet
    ViewArea* viewArea_ = nullptr;
    ViewsPanel* viewsPanel_ = nullptr;
    PartsPanel* parts_ = nullptr;
    AccuracyPanel* accuracy_ = nullptr;
};

}  // namespace vestige
