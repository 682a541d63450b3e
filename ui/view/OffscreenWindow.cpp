#include "ui/view/OffscreenWindow.h"

#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

namespace vestige {

struct OffscreenWindow::Private {
    std::unique_ptr<GlContext> context;
    vtkNew<vtkGenericOpenGLRenderWindow> window;

    void observe(unsigned long event, void (*answer)(vtkObject*, unsigned long, void*, void*)) {
        vtkNew<vtkCallbackCommand> command;
        command->SetClientData(context.get());
        command->SetCallback(answer);
        window->AddObserver(event, command);
    }
};

OffscreenWindow::OffscreenWindow(std::unique_ptr<GlContext> context) : d_(std::make_unique<Private>()) {
    d_->context = std::move(context);
    d_->context->makeCurrent();
    d_->observe(vtkCommand::WindowMakeCurrentEvent, [](vtkObject*, unsigned long, void* gl, void*) {
        static_cast<GlContext*>(gl)->makeCurrent();
    });
    d_->observe(vtkCommand::WindowIsCurrentEvent, [](vtkObject*, unsigned long, void* gl, void* answer) {
        *static_cast<bool*>(answer) = static_cast<GlContext*>(gl)->isCurrent();
    });
    auto& window = *d_->window;
    window.SetOwnContext(0);
    window.SetReadyForRendering(true);
    window.SetMapped(true);
    window.SetSupportsOpenGL(1);
    window.SetIsDirect(1);
    window.SetMultiSamples(0);
    window.SetOffScreenRendering(1);
    window.SetFrameBlitModeToNoBlit();
    window.OpenGLInitContext();
}

OffscreenWindow::~OffscreenWindow() {
    d_->context->makeCurrent();
    d_->window->Finalize();
    d_->window->RemoveAllObservers();
}

vtkRenderWindow& OffscreenWindow::renderWindow() {
    return *d_->window;
}

void OffscreenWindow::resize(const QSize& pixels) {
    d_->window->SetSize(pixels.width(), pixels.height());
}

void OffscreenWindow::render() {
    d_->window->Render();
    d_->window->WaitForCompletion();
}

QImage OffscreenWindow::draw(bool withCover) {
    d_->window->Render();
    const int* size = d_->window->GetSize();
    QImage picture(size[0], size[1], QImage::Format_RGBA8888_Premultiplied);
    const std::unique_ptr<unsigned char[]> pixels(
        d_->window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 0));
    if (!pixels) return {};
    const qsizetype row = qsizetype{4} * size[0];
    for (int y = 0; y < size[1]; ++y)
        std::copy_n(pixels.get() + row * (size[1] - 1 - y), row, picture.scanLine(y));
    if (withCover) return picture.convertToFormat(QImage::Format_ARGB32_Premultiplied);
    // What the window leaves there is not to become part of the colours.
    return std::move(picture)
        .convertToFormat(QImage::Format_ARGB32_Premultiplied)
        .convertToFormat(QImage::Format_RGB32);
}

}  // namespace vestige
