#pragma once

#include <QApplication>
#include <memory>

#include "core/pipeline/ViewRenderer.h"
#include "ui/view/ViewSurface.h"

namespace vestige {

/// A QApplication without a display: Qt's `offscreen` platform, software OpenGL. Made before any widget,
/// picture or PDF; one per process. The environment's DISPLAY and QT_QPA_PLATFORM play no part.
class OffscreenApplication {
  public:
    /// `scale`: pixels of a screen for each of a window, whatever the desktop of the user asks for.
    explicit OffscreenApplication(double scale = 1);
    ~OffscreenApplication();
    QApplication& application();

  private:
    struct Private;
    std::unique_ptr<Private> d_;
};

/// Surfaces for MainWindow and SceneView that paint what OSMesa draws.
ViewSurfaceFactory offscreenSurface();

/// Draws pictures with OSMesa; needs an OffscreenApplication while it lives.
std::unique_ptr<ViewRenderer> offscreenRenderer();

}  // namespace vestige
