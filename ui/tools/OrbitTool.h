#pragma once

#include "ui/tools/HoverProbe.h"
#include "ui/view/ViewTool.h"

namespace vestige {

class PickChoices;
class PickMover;

/// Leaves the mouse to navigation and tells what is under the cursor. Picks of the selected object can be
/// moved where PickChoices allows it. A double click sets what the view turns about.
class OrbitTool : public ViewTool {
  public:
    OrbitTool(HoverProbe& probe, PickMover& mover, const PickChoices& choices)
        : probe_(probe), mover_(mover), choices_(choices) {}

    void leave(SceneView& view) override;
    bool mousePress(SceneView& view, const QMouseEvent& event) override;
    bool mouseMove(SceneView& view, const QMouseEvent& event) override;
    bool mouseRelease(SceneView& view, const QMouseEvent& event) override;
    bool mouseDoubleClick(SceneView& view, const QMouseEvent& event) override;
    bool keyPress(SceneView& view, const QKeyEvent& event) override;
    bool holdsKey(const SceneView& view, const QKeyEvent& event) const override;
    void paint(const SceneView& view, QPainter& painter, const ViewCamera& camera,
               const ViewTheme& theme) const override;

  private:
    HoverProbe& probe_;
    PickMover& mover_;
    const PickChoices& choices_;
};

}  // namespace vestige
