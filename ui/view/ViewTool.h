#pragma once

class QKeyEvent;
class QMouseEvent;
class QPainter;
class QWheelEvent;

namespace vestige {

class SceneView;
struct ViewCamera;
struct ViewTheme;

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
    /// Comes in the place of the second press of a double click; a release follows. Not taken, it does
    /// nothing.
    virtual bool mouseDoubleClick(SceneView&, const QMouseEvent&) { return false; }
    virtual bool wheel(SceneView&, const QWheelEvent&) { return false; }
    virtual bool keyPress(SceneView&, const QKeyEvent&) { return false; }
    /// True for a key that keyPress would take now and that no shortcut may take before.
    virtual bool holdsKey(const SceneView&, const QKeyEvent&) const { return false; }
    /// Paints over the picture and its marks, in pixels of `camera`; only of the active tool.
    virtual void paint(const SceneView&, QPainter&, const ViewCamera&, const ViewTheme&) const {}
};

}  // namespace vestige
