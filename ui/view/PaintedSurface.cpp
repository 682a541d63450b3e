#include "ui/view/PaintedSurface.h"

#include <vtkGenericOpenGLRenderWindow.h>

#include <QPaintEvent>
#include <QPainter>
#include <QWidget>

#include "ui/view/OffscreenWindow.h"

namespace vestige {
namespace {

class FrameWidget : public QWidget {
  public:
    using QWidget::QWidget;

    void showFrame(QImage frame) {
        frame_ = std::move(frame);
        update();
    }

  protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        if (!frame_.isNull()) painter.drawImage(rect(), frame_);
    }

  private:
    QImage frame_;
};

class PaintedSurface : public ViewSurface {
  public:
    PaintedSurface(std::unique_ptr<GlContext> context, QWidget* parent)
        : window_(std::move(context)), widget_(new FrameWidget(parent)) {
        widget_->setAttribute(Qt::WA_OpaquePaintEvent);
    }

    QWidget* widget() override { return widget_; }
    vtkRenderWindow& renderWindow() override { return window_.renderWindow(); }

    bool drawFrame() override {
        if (widget_->size().isEmpty()) return false;
        window_.resize(widget_->size() * widget_->devicePixelRatioF());
        widget_->showFrame(window_.draw());
        return true;
    }

  private:
    OffscreenWindow window_;
    FrameWidget* widget_;
};

}  // namespace

ViewSurfaceFactory paintedSurface(GlContextFactory contexts) {
    return [contexts = std::move(contexts)](QWidget* parent) -> std::unique_ptr<ViewSurface> {
        std::unique_ptr<GlContext> context = contexts();
        if (!context) qFatal("no off-screen drawing context");
        return std::make_unique<PaintedSurface>(std::move(context), parent);
    };
}

}  // namespace vestige
