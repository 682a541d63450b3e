#pragma once

#include <QSurfaceFormat>

namespace vestige {

/// Of the contexts that VTK draws with on the desktop: OpenGL 3.2, core profile, the oldest that it takes.
QSurfaceFormat nativeFormat();

}  // namespace vestige
