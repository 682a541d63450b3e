#pragma once

#include <functional>
#include <memory>

class QWidget;
class vtkRenderWindow;

namespace vestige {

/// The widget that shows the 3D picture and the VTK window that draws it. Two kinds exist:
/// QVTKOpenGLNativeWidget in the desktop program, and a plain widget that paints the frames of an OSMesa
/// window off screen.
class ViewSurface {
  public:
    virtual ~ViewSurface() = default;
    /// Owned by its Qt parent.
    virtual QWidget* widget() = 0;
    virtual vtkRenderWindow& renderWindow() = 0;
    /// Shows the current state soon; several calls before the next paint draw once.
    virtual void requestFrame() = 0;
};

/// Given to MainWindow by the program's main.
using ViewSurfaceFactory = std::function<std::unique_ptr<ViewSurface>(QWidget* parent)>;

}  // namespace vestige
