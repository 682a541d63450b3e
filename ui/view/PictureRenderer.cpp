#include "ui/view/PictureRenderer.h"

#include <vtkGenericOpenGLRenderWindow.h>

#include <QPainter>

#include "ui/view/OffscreenWindow.h"
#include "ui/view/Overlay.h"
#include "ui/view/PngFile.h"
#include "ui/view/SceneDrawing.h"

namespace vestige {
namespace {

constexpr int kLargestSide = 16384;

class PictureRenderer : public ViewRenderer {
  public:
    explicit PictureRenderer(GlContextFactory contexts) : contexts_(std::move(contexts)) {}

    Status renderPng(const ViewDescription& view, const std::filesystem::path& png,
                     const JobControl& control) override {
        return guarded(png.string(), [&]() -> Status {
            const QSize size(view.camera.width_px, view.camera.height_px);
            if (size.width() < 1 || size.height() < 1 || std::max(size.width(), size.height()) > kLargestSide)
                return fail(ErrorCode::usage,
                            "a picture of " + std::to_string(size.width()) + " x " +
                                std::to_string(size.height()) + " pixels cannot be drawn",
                            png.string(), "1 to " + std::to_string(kLargestSide) + " a side");
            if (const Status ready = prepare(); !ready) return ready;
            control.progress(0, "drawing " + png.filename().string());
            window_->resize(size);
            drawing_->show(view);
            drawing_->setCamera(view.camera);
            drawing_->beginPicture(1);
            QImage picture = window_->draw();
            if (control.cancelled()) return fail(cancelledError());
            if (picture.isNull())
                return fail(ErrorCode::output, "the picture could not be drawn", png.string());
            QPainter painter(&picture);
            paintOverlay(painter, {view, view.camera, drawing_->scale(), std::nullopt});
            painter.end();
            const Status written = writePng(picture, png);
            control.progress(1);
            return written;
        });
    }

  private:
    Status prepare() {
        if (drawing_) return {};
        std::unique_ptr<GlContext> context = contexts_();
        if (!context)
            return fail(ErrorCode::output, "this machine gives no OpenGL 3.2 context to draw pictures with");
        window_ = std::make_unique<OffscreenWindow>(std::move(context));
        drawing_ = std::make_unique<SceneDrawing>(window_->renderWindow());
        return {};
    }

    GlContextFactory contexts_;
    std::unique_ptr<OffscreenWindow> window_;
    std::unique_ptr<SceneDrawing> drawing_;
};

}  // namespace

std::unique_ptr<ViewRenderer> pictureRenderer(GlContextFactory contexts) {
    return std::make_unique<PictureRenderer>(std::move(contexts));
}

}  // namespace vestige
