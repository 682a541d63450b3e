#include "ui/view/PictureRenderer.h"

#include <vtkGenericOpenGLRenderWindow.h>

#include <QPainter>

#include "ui/view/OffscreenWindow.h"
#include "ui/view/Overlay.h"
#include "ui/view/PngFile.h"
#include "ui/view/SceneDrawing.h"
#include "ui/view/SteppedRenderer.h"
#include "ui/watch/WatchedTime.h"

namespace vestige {
namespace {

constexpr int kLargestSide = 16384;
/// Points drawn in one step: at most 0.2 s on two cores without a graphics card.
constexpr double kStepPoints = 800'000;

class PictureRenderer : public SteppedRenderer {
  public:
    explicit PictureRenderer(GlContextFactory contexts) : contexts_(std::move(contexts)) {}

    Status renderPng(const ViewDescription& view, const std::filesystem::path& png,
                     const JobControl& control) override {
        return guarded(png.string(), [&]() -> Status {
            control.progress(0, "drawing " + png.filename().string());
            if (const Status begun = begin(view, png.string()); !begun) return begun;
            std::optional<Result<QImage>> picture;
            while (!picture) {
                if (control.cancelled()) return fail(cancelledError());
                picture = step();
                control.progress(share_);
            }
            if (!*picture) return fail(picture->error());
            const Status written = writePng(**picture, png);
            control.progress(1);
            return written;
        });
    }

    Status begin(const ViewDescription& view, const std::string& place) override {
        const QSize size(view.camera.width_px, view.camera.height_px);
        if (size.width() < 1 || size.height() < 1 || std::max(size.width(), size.height()) > kLargestSide)
            return fail(ErrorCode::usage,
                        "a picture of " + std::to_string(size.width()) + " x " +
                            std::to_string(size.height()) + " pixels cannot be drawn",
                        place, "1 to " + std::to_string(kLargestSide) + " a side");
        if (const Status ready = prepare(); !ready) return ready;
        view_ = view;
        place_ = place;
        share_ = 0;
        window_->resize(size);
        drawing_->show(view);
        drawing_->setCamera(view.camera);
        return {};
    }

    std::optional<Result<QImage>> step() override {
        const bool first = share_ == 0;
        const double wanted = static_cast<double>(drawing_->pointsWanted());
        share_ = wanted <= kStepPoints ? 1 : std::min(1.0, share_ + kStepPoints / wanted);
        if (first)
            drawing_->beginPicture(share_);
        else
            drawing_->addToPicture(share_);
        QImage picture;
        {
            const DrawingTime watched;
            if (share_ < 1)
                window_->render();
            else
                picture = window_->draw();
        }
        if (share_ < 1) return std::nullopt;
        if (picture.isNull())
            return Result<QImage>(fail(ErrorCode::output, "the picture could not be drawn", place_));
        QPainter painter(&picture);
        paintOverlay(painter, {view_, view_.camera, drawing_->scale(), std::nullopt});
        painter.end();
        return Result<QImage>(std::move(picture));
    }

    double share() const override { return share_; }

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
    ViewDescription view_;  ///< of the picture that was begun
    std::string place_;
    double share_ = 0;
};

}  // namespace

std::unique_ptr<ViewRenderer> pictureRenderer(GlContextFactory contexts) {
    return std::make_unique<PictureRenderer>(std::move(contexts));
}

}  // namespace vestige
