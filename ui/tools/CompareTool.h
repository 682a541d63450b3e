#pragma once

#include <QCursor>
#include <QObject>

#include "ui/view/ViewTool.h"

namespace vestige {

class Comparison;

/// The hand on a comparison: drags the divider of a swipe; the keys Left and Right move it, or change the
/// size of the tiles or the speed of the blinking; Space holds the blinking. What it does not take goes to
/// the active tool.
class CompareTool : public QObject, public ViewTool {
    Q_OBJECT

  public:
    explicit CompareTool(Comparison& comparison, QObject* parent = nullptr);

    bool mousePress(SceneView& view, const QMouseEvent& event) override;
    bool mouseMove(SceneView& view, const QMouseEvent& event) override;
    bool mouseRelease(SceneView& view, const QMouseEvent& event) override;
    bool keyPress(SceneView& view, const QKeyEvent& event) override;

  private:
    bool onDivider(const SceneView& view, const QMouseEvent& event) const;

    Comparison& comparison_;
    bool dragging_ = false;
    bool pointing_ = false;  ///< the cursor tells of the divider
    QCursor before_;
};

}  // namespace vestige
