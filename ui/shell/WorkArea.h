#pragma once

#include <QWidget>

#include "ui/actions/Workbench.h"

class QStackedWidget;
class QVBoxLayout;

namespace vestige {

class SceneView;
class StepBar;
class StepTabs;
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

  signals:
    /// A recent file was chosen.
    void chosen(const QString& path);

  private:
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
    ViewArea* area_ = nullptr;
    QStackedWidget* empty_ = nullptr;
    bool begun_ = false;  ///< a case, though it may be empty yet
};

}  // namespace vestige
