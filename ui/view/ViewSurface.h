#pragma once

#include <functional>
#include <memory>

class QWidget;
class vtkRenderWindow;

namespace vestige {

/// The widget that shows the 3D picture and the VTK window that draws it. Two kinds exist:
/// A QOpenGLWidget in the desktop program, and a plain widget that paints the frames of an off-screen
/// context.
class ViewSurface {
  public:
    virtual ~ViewSurface() = default;
    /// Owned by its Qt parent; lives at least as long as this object.
    virtual QWidget* widget() = 0;
    virtual vtkRenderWindow& renderWindow() = 0;
    /// Draws the window's present state and shows it; waits until it is drawn. False (and nothing drawn)
    /// while the widget has no context yet.
    virtual bool drawFrame() = 0;
};

/// Given to MainWindow by the program's main.
using ViewSurfaceFactory = std::function<std::unique_ptr<ViewSurface>(QWidget* parent)>;

}  // namespace vestige
