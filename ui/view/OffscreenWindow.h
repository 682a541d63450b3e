#pragma once

#include <QImage>
#include <QSize>
#include <memory>

#include "ui/view/GlContext.h"

class vtkRenderWindow;

namespace vestige {

/// A VTK render window on a context without a window system, and its pictures.
class OffscreenWindow {
  public:
    explicit OffscreenWindow(std::unique_ptr<GlContext> context);
    ~OffscreenWindow();

    vtkRenderWindow& renderWindow();
    void resize(const QSize& pixels);
    /// Draws the window's renderers.
    void render();
    /// The same, and reads the picture back; opaque unless `withCover`, which keeps where nothing is.
    QImage draw(bool withCover = false);

  private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace vestige
