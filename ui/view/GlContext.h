#pragma once

#include <functional>
#include <memory>

namespace vestige {

/// An OpenGL core context (3.2 or later) that belongs to no window: VTK draws into framebuffers of its own.
/// app/offscreen gives one of OSMesa; the desktop program one of the graphics driver. Main thread only.
class GlContext {
  public:
    virtual ~GlContext() = default;
    virtual bool makeCurrent() = 0;
    virtual bool isCurrent() const = 0;
};

/// Null when the machine gives no such context.
using GlContextFactory = std::function<std::unique_ptr<GlContext>()>;

}  // namespace vestige
