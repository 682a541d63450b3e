#include "ui/view/NativeSurface.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include <QSurfaceFormat>

namespace vestige {
namespace {

QSurfaceFormat format() {
    QSurfaceFormat wanted = QVTKOpenGLNativeWidget::defaultFormat();
    wanted.setSamples(0);
    return wanted;
}

class NativeSurface : public ViewSurface {
  public:
    explicit NativeSurface(QWidget* parent) : widget_(new QVTKOpenGLNativeWidget(parent)) {
        vtkNew<vtkGenericOpenGLRenderWindow> window;
        window->SetMultiSamples(0);
        widget_->setFormat(format());
        widget_->setRenderWindow(window.Get());
        widget_->setCursor(Qt::ArrowCursor);
    }

    QWidget* widget() override { return widget_; }
    vtkRenderWindow& renderWindow() override { return *widget_->renderWindow(); }

    bool drawFrame() override {
        // The context exists from the widget's first paint on.
        if (!widget_->isValid() || widget_->size().isEmpty()) return false;
        widget_->renderWindow()->Render();
        widget_->renderWindow()->WaitForCompletion();
        widget_->update();
        return true;
    }

  private:
    QVTKOpenGLNativeWidget* widget_;
};

}  // namespace

ViewSurfaceFactory nativeSurface() {
    return [](QWidget* parent) { return std::make_unique<NativeSurface>(parent); };
}

void setNativeSurfaceFormat() {
    QSurfaceFormat::setDefaultFormat(format());
}

}  // namespace vestige
