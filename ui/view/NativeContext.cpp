#include <QOffscreenSurface>
#include <QOpenGLContext>

#include "ui/view/NativeFormat.h"
#include "ui/view/PictureRenderer.h"

namespace vestige {
namespace {

class NativeContext : public GlContext {
  public:
    bool create() {
        const QSurfaceFormat format = nativeFormat();
        context_.setFormat(format);
        surface_.setFormat(format);
        surface_.create();
        return context_.create() && makeCurrent();
    }
    bool makeCurrent() override { return context_.makeCurrent(&surface_); }
    bool isCurrent() const override { return QOpenGLContext::currentContext() == &context_; }

  private:
    QOffscreenSurface surface_;
    QOpenGLContext context_;
};

}  // namespace

std::unique_ptr<ViewRenderer> nativeRenderer() {
    return pictureRenderer([]() -> std::unique_ptr<GlContext> {
        auto context = std::make_unique<NativeContext>();
        if (!context->create()) return nullptr;
        return context;
    });
}

}  // namespace vestige
