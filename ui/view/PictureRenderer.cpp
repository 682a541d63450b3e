#include "ui/view/PictureRenderer.h"

#include <vtkGenericOpenGLRenderWindow.h>

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/view/OffscreenWindow.h"
#include "ui/view/Overlay.h"
#include "ui/view/PngFile.h"
#include "ui/view/SceneDrawing.h"

namespace vestige {
namespace {

/// Points whose middle lies outside of a part reach into it, and light looks two pixels aside.
constexpr int kMargin_px = 32;
/// What letters and lines are made for.
constexpr double kWindow_dpi = 96;
constexpr double kMetresPerInch = 0.0254;
/// Legend and scale bar would cover most of a picture that is smaller than this in their pixels.
constexpr double kLeastLettered_px = 300;

class PictureRenderer : public ViewRenderer {
  public:
    PictureRenderer(GlContextFactory contexts, int tile_px)
        : contexts_(std::move(contexts)), tile_px_(tile_px) {}

    Status renderPng(const ViewDescription& view, const std::filesystem::path& png,
                     const JobControl& control) override {
        return guarded(png.string(), [&]() -> Status {
            const QSize size(view.camera.width_px, view.camera.height_px);
            const long pixels = static_cast<long>(size.width()) * size.height();
            if (size.width() < 1 || size.height() < 1 ||
                std::max(size.width(), size.height()) > kLargestSide_px || pixels > kMostPixels)
                return fail(ErrorCode::usage,
                            "a picture of " + std::to_string(size.width()) + " x " +
                                std::to_string(size.height()) + " pixels cannot be drawn",
                            png.string(),
                            "1 to " + std::to_string(kLargestSide_px) + " a side, " +
                                std::to_string(kMostPixels / 1000000) + " million in all");
            if (const Status ready = prepare(); !ready) return ready;
            control.progress(0, "drawing " + png.filename().string());
            drawing_->show(view);
            QImage picture =
                std::max(size.width(), size.height()) <= tile_px_ ? drawn(view) : drawnInParts(view, control);
            if (control.cancelled()) return fail(cancelledError());
            if (picture.isNull())
                return fail(ErrorCode::output, "the picture could not be drawn", png.string());
            paintOver(picture, view);
            const Status written = writePng(picture, png);
            control.progress(1);
            return written;
        });
    }

  private:
    QImage drawn(const ViewDescription& view) {
        window_->resize({view.camera.width_px, view.camera.height_px});
        drawing_->setCamera(view.camera);
        drawing_->beginPicture(1);
        return window_->draw(view.transparent);
    }

    QImage drawnInParts(const ViewDescription& view, const JobControl& control) {
        const int width = view.camera.width_px;
        const int height = view.camera.height_px;
        QImage whole(width, height,
                     view.transparent ? QImage::Format_ARGB32_Premultiplied : QImage::Format_RGB32);
        if (whole.isNull()) return whole;
        const int inner = std::max(1, tile_px_ - 2 * kMargin_px);
        const int parts = ((width + inner - 1) / inner) * ((height + inner - 1) / inner);
        int done = 0;
        window_->resize({tile_px_, tile_px_});
        QPainter onto(&whole);
        onto.setCompositionMode(QPainter::CompositionMode_Source);
        for (int top = 0; top < height; top += inner)
            for (int left = 0; left < width; left += inner) {
                if (control.cancelled()) return {};
                drawing_->setCamera(view.camera, {left - kMargin_px, top - kMargin_px, tile_px_, tile_px_});
                drawing_->beginPicture(1);
                const QImage part = window_->draw(view.transparent);
                if (part.isNull()) return {};
                onto.drawImage(QPoint(left, top), part, QRect(kMargin_px, kMargin_px, inner, inner));
                control.progress(0.9 * ++done / parts);
            }
        return whole;
    }

    /// Lettering has the size on paper that it has in the window.
    void paintOver(QImage& picture, const ViewDescription& view) const {
        if (view.scale.dpi) {
            const int dots = static_cast<int>(std::lround(*view.scale.dpi / kMetresPerInch));
            picture.setDotsPerMeterX(dots);
            picture.setDotsPerMeterY(dots);
        }
        // Fonts are in pixels of the painter: what the file says of itself must not enlarge them twice.
        QPainter painter(&picture);
        const double most = std::min(picture.width(), picture.height()) / kLeastLettered_px;
        const double factor =
            view.scale.dpi ? std::max(1.0, std::min(*view.scale.dpi / kWindow_dpi, most)) : 1.0;
        ViewCamera camera = view.camera;
        camera.width_px = std::max(1, static_cast<int>(std::lround(picture.width() / factor)));
        camera.height_px = std::max(1, static_cast<int>(std::lround(picture.height() / factor)));
        painter.scale(static_cast<double>(picture.width()) / camera.width_px,
                      static_cast<double>(picture.height()) / camera.height_px);
        paintOverlay(painter, {view, camera, drawing_->scale(), std::nullopt});
    }

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
    int tile_px_;
    std::unique_ptr<OffscreenWindow> window_;
    std::unique_ptr<SceneDrawing> drawing_;
};

}  // namespace

std::unique_ptr<ViewRenderer> pictureRenderer(GlContextFactory contexts, int tile_px) {
    return std::make_unique<PictureRenderer>(std::move(contexts), std::max(tile_px, 2 * kMargin_px + 1));
}

}  // namespace vestige
