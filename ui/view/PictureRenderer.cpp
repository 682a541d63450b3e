#include "ui/view/PictureRenderer.h"

#include <vtkGenericOpenGLRenderWindow.h>

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <vector>

#include "ui/view/OffscreenWindow.h"
#include "ui/view/Overlay.h"
#include "ui/view/PngFile.h"
#include "ui/view/SceneDrawing.h"
#include "ui/view/SteppedRenderer.h"
#include "ui/watch/WatchedTime.h"

namespace vestige {
namespace {

/// Points whose middle lies outside of a part reach into it, and light looks two pixels aside.
constexpr int kMargin_px = 32;
/// What letters and lines are made for.
constexpr double kWindow_dpi = 96;
constexpr double kMetresPerInch = 0.0254;
/// Points drawn in one step: at most 0.2 s on two cores without a graphics card.
constexpr double kStepPoints = 800000;
/// Legend and scale bar would cover most of a picture that is smaller than this in their pixels.
constexpr double kLeastLettered_px = 300;

/// A picture larger than the framebuffer is drawn in parts; each part, or the whole, in steps.
class PictureRenderer : public SteppedRenderer {
  public:
    PictureRenderer(GlContextFactory contexts, int tile_px)
        : contexts_(std::move(contexts)), tile_px_(tile_px) {}

    Status renderPng(const ViewDescription& view, const std::filesystem::path& png,
                     const JobControl& control) override {
        return guarded(png.string(), [&]() -> Status {
            control.progress(0, "drawing " + png.filename().string());
            if (const Status begun = begin(view, png.string()); !begun) return begun;
            std::optional<Result<QImage>> picture;
            while (!picture) {
                if (control.cancelled()) return fail(cancelledError());
                picture = step();
                control.progress(share());
            }
            if (!*picture) return fail(picture->error());
            const Status written = writePng(**picture, png);
            control.progress(1);
            return written;
        });
    }

    Status begin(const ViewDescription& view, const std::string& place) override {
        const QSize size(view.camera.width_px, view.camera.height_px);
        const long pixels = static_cast<long>(size.width()) * size.height();
        if (size.width() < 1 || size.height() < 1 ||
            std::max(size.width(), size.height()) > kLargestSide_px || pixels > kMostPixels)
            return fail(ErrorCode::usage,
                        "a picture of " + std::to_string(size.width()) + " x " +
                            std::to_string(size.height()) + " pixels cannot be drawn",
                        place,
                        "1 to " + std::to_string(kLargestSide_px) + " a side, " +
                            std::to_string(kMostPixels / 1000000) + " million in all");
        if (const Status ready = prepare(); !ready) return ready;
        view_ = view;
        place_ = place;
        divide(size);
        done_ = 0;
        share_ = 0;
        drawing_->show(view_);
        return {};
    }

    std::optional<Result<QImage>> step() override {
        const bool first = share_ == 0;
        if (first) aim();
        const double wanted = static_cast<double>(drawing_->pointsWanted());
        share_ = wanted <= kStepPoints ? 1 : std::min(1.0, share_ + kStepPoints / wanted);
        if (first)
            drawing_->beginPicture(share_);
        else
            drawing_->addToPicture(share_);
        const DrawingTime watched;
        if (share_ < 1) {
            window_->render();
            return std::nullopt;
        }
        const QImage part = window_->draw(view_.transparent);
        if (part.isNull() || !take(part))
            return Result<QImage>(fail(ErrorCode::output, "the picture could not be drawn", place_));
        if (++done_ < parts_.size()) {
            share_ = 0;
            return std::nullopt;
        }
        paintOver(whole_);
        return Result<QImage>(std::move(whole_));
    }

    double share() const override {
        return parts_.empty() ? 0 : std::min(1.0, (static_cast<double>(done_) + share_) / parts_.size());
    }

  private:
    /// The corners of the parts; one of its own size for a picture that fits.
    void divide(const QSize& size) {
        parts_.clear();
        whole_ = QImage();
        inParts_ = std::max(size.width(), size.height()) > tile_px_;
        window_->resize(inParts_ ? QSize(tile_px_, tile_px_) : size);
        const int inner =
            inParts_ ? std::max(1, tile_px_ - 2 * kMargin_px) : std::max(size.width(), size.height());
        for (int top = 0; top < size.height(); top += inner)
            for (int left = 0; left < size.width(); left += inner) parts_.emplace_back(left, top);
    }

    void aim() {
        const QPoint corner = parts_[done_];
        if (inParts_)
            drawing_->setCamera(view_.camera,
                                {corner.x() - kMargin_px, corner.y() - kMargin_px, tile_px_, tile_px_});
        else
            drawing_->setCamera(view_.camera);
    }

    /// Puts a drawn part into its place.
    bool take(const QImage& part) {
        if (!inParts_) {
            whole_ = part;
            return true;
        }
        if (whole_.isNull())
            whole_ = QImage(view_.camera.width_px, view_.camera.height_px,
                            view_.transparent ? QImage::Format_ARGB32_Premultiplied : QImage::Format_RGB32);
        if (whole_.isNull()) return false;
        const int inner = std::max(1, tile_px_ - 2 * kMargin_px);
        QPainter onto(&whole_);
        onto.setCompositionMode(QPainter::CompositionMode_Source);
        onto.drawImage(parts_[done_], part, QRect(kMargin_px, kMargin_px, inner, inner));
        return true;
    }

    /// Lettering has the size on paper that it has in the window.
    void paintOver(QImage& picture) const {
        if (view_.scale.dpi) {
            const int dots = static_cast<int>(std::lround(*view_.scale.dpi / kMetresPerInch));
            picture.setDotsPerMeterX(dots);
            picture.setDotsPerMeterY(dots);
        }
        // Fonts are in pixels of the painter: what the file says of itself must not enlarge them twice.
        QPainter painter(&picture);
        const double most = std::min(picture.width(), picture.height()) / kLeastLettered_px;
        const double factor =
            view_.scale.dpi ? std::max(1.0, std::min(*view_.scale.dpi / kWindow_dpi, most)) : 1.0;
        ViewCamera camera = view_.camera;
        camera.width_px = std::max(1, static_cast<int>(std::lround(picture.width() / factor)));
        camera.height_px = std::max(1, static_cast<int>(std::lround(picture.height() / factor)));
        painter.scale(static_cast<double>(picture.width()) / camera.width_px,
                      static_cast<double>(picture.height()) / camera.height_px);
        paintOverlay(painter, {view_, camera, drawing_->scale(), std::nullopt});
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
    ViewDescription view_;  ///< of the picture that was begun
    std::string place_;
    std::vector<QPoint> parts_;  ///< their corners
    bool inParts_ = false;
    std::size_t done_ = 0;  ///< parts
    double share_ = 0;      ///< of the part's points
    QImage whole_;
};

}  // namespace

std::unique_ptr<ViewRenderer> pictureRenderer(GlContextFactory contexts, int tile_px) {
    return std::make_unique<PictureRenderer>(std::move(contexts), std::max(tile_px, 2 * kMargin_px + 1));
}

}  // namespace vestige
