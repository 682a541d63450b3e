#pragma once

#include <QObject>

#include "ui/actions/Workbench.h"
#include "ui/document/PointSelection.h"
#include "ui/tools/HoverProbe.h"
#include "ui/tools/OutlineTool.h"

namespace vestige {

class SceneView;

/// Lasso and box as tools of the view, and the selecting of what they enclose, on the job runner.
class CleaningTools : public QObject {
    Q_OBJECT

  public:
    /// `probe` tells the point under the cursor between the clicks.
    CleaningTools(const Workbench& bench, SceneView& view, HoverProbe& probe, QObject* parent = nullptr);
    OutlineTool& lasso() { return lasso_; }
    OutlineTool& box() { return box_; }

  signals:
    void hintChanged(const QString& hint);

  private:
    void select(const std::vector<Eigen::Vector2d>& corners, Qt::KeyboardModifiers modifiers,
                const char* how);

    Workbench bench_;
    SceneView& view_;
    OutlineTool lasso_;
    OutlineTool box_;
};

}  // namespace vestige
