#pragma once

#include "ui/tools/HoverProbe.h"
#include "ui/view/ViewTool.h"

namespace vestige {

/// Leaves the mouse to navigation and tells what is under the cursor. A double click sets what the view turns
/// about.
class OrbitTool : public ViewTool {
  public:
    explicit OrbitTool(HoverProbe& probe) : probe_(probe) {}
    void leave(SceneView&) override { probe_.stop(); }
    bool mouseDoubleClick(SceneView& view, const QMouseEvent& event) override;
    bool mouseMove(SceneView& view, const QMouseEvent& event) override {
        probe_.moved(view, event);
        return false;
    }

  private:
    HoverProbe& probe_;
};

}  // namespace vestige
