#pragma once

#include <QWidget>

#include "ui/actions/Workbench.h"

class QSplitter;
class QVBoxLayout;

namespace vestige {

class SceneView;
class ToolSwitch;
class ViewArea;
class ViewsPanel;

/// The middle of the window: case at the left, view with registration strip, measurements and alignment at
/// the right, the notice above.
class WorkArea : public QWidget {
    Q_OBJECT

  public:
    WorkArea(const Workbench& bench, SceneView& view, ToolSwitch& tools, QWidget* parent = nullptr);

    /// One more above the view.
    void addBar(QWidget* bar);

    ViewArea& viewArea() { return *viewArea_; }
    ViewsPanel& viewsPanel() { return *viewsPanel_; }

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
    ViewArea* viewArea_ = nullptr;
    ViewsPanel* viewsPanel_ = nullptr;
};

}  // namespace vestige
