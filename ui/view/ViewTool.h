#pragma once

class QMouseEvent;
class QKeyEvent;
class QWheelEvent;

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
    /// Comes in the place of the second press of a double click. Not taken, it does nothing.
    virtual bool mouseDoubleClick(SceneView&, const QMouseEvent&) { return false; }
    virtual bool wheel(SceneView&, const QWheelEvent&) { return false; }
    virtual bool keyPress(SceneView&, const QKeyEvent&) { return false; }
};

}  // namespace vestige
