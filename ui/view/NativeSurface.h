#pragma once

#include "ui/view/ViewSurface.h"

class QSurfaceFormat;

namespace vestige {

/// Surfaces of the desktop program: a QOpenGLWidget.
ViewSurfaceFactory nativeSurface();

/// Call once before the QApplication is made: the OpenGL format that VTK needs.
void setNativeSurfaceFormat();

}  // namespace vestige
