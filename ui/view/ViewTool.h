#pragma once

class QMouseEvent;
class QKeyEvent;

namespace vestige {

class SceneView;

/// What the mouse does in the view besides navigation. The active tool sees an event first; what it does not
/// take (returns false) orbits, pans and zooms.
class ViewTool {
  public:
    virtual ~ViewTool() = default;
    virtual void enter(SceneView&) {}
    virtual void leave(SceneView&) {}
    virtual bool mousePress(SceneView&, const QMouseEvent&) { return false; }
    virtual bool mouseMove(SceneView&, const QMouseEvent&) { return false; }
    virtual bool mouseRelease(SceneView&, const QMouseEvent&) { return false; }
    virtual bool mouseDoubleClick(SceneView&, const QMouseEvent&) { return false; }
    /// Keys that come to keyPress although they are shortcuts of the window.
    virtual bool wantsKey(const QKeyEvent&) const { return false; }
    virtual bool keyPress(SceneView&, const QKeyEvent&) { return false; }
};

}  // namespace vestige
