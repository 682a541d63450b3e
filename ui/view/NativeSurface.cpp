#include "ui/view/NativeSurface.h"

#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>

#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QOpenGLWidget>

#include "ui/view/NativeFormat.h"

namespace vestige {
namespace {

/// A widget whose context VTK draws with, into framebuffers of its own; painting copies the last picture. VTK's
/// widget for Qt does the same, and brings thirty libraries that nothing here uses (MPI among them) to every
/// start of the program.
class NativeWidget : public QOpenGLWidget {
  public:
    explicit NativeWidget(QWidget* parent) : QOpenGLWidget(parent) {
        setFormat(nativeFormat());
        observe(vtkCommand::WindowMakeCurrentEvent, [](vtkObject*, unsigned long, void* widget, void*) {
            static_cast<NativeWidget*>(widget)->takeContext();
        });
        observe(vtkCommand::WindowIsCurrentEvent, [](vtkObject*, unsigned long, void* widget, void* answer) {
            const auto* context = static_cast<NativeWidget*>(widget)->context();
            *static_cast<bool*>(answer) = context && context == QOpenGLContext::currentContext();
        });
        window_->SetOwnContext(0);
        window_->SetMultiSamples(0);
        window_->SetMapped(true);
        window_->SetSupportsOpenGL(1);
        window_->SetIsDirect(1);
        window_->SetFrameBlitModeToNoBlit();
        // Until there is a context.
        window_->SetReadyForRendering(false);
    }
    ~NativeWidget() override { release(); }

    vtkGenericOpenGLRenderWindow& window() { return *window_; }

    bool draw() {
        // The context exists from the widget's first paint on.
        if (!isValid() || size().isEmpty()) return false;
        makeCurrent();
        const QSize pixels = size() * devicePixelRatioF();
        window_->SetSize(pixels.width(), pixels.height());
        // Qt has bound its own framebuffer since VTK drew last.
        window_->GetState()->Reset();
        window_->Render();
        window_->WaitForCompletion();
        drawn_ = true;
        update();
        return true;
    }

  protected:
    void initializeGL() override {
        connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { release(); });
        window_->SetReadyForRendering(true);
        window_->OpenGLInitContext();
    }

    void paintGL() override {
        auto& gl = *context()->extraFunctions();
        gl.glDisable(GL_SCISSOR_TEST);
        gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
        gl.glClearColor(0, 0, 0, 1);
        gl.glClear(GL_COLOR_BUFFER_BIT);
        if (drawn_) {
            const int* from = window_->GetSize();
            const QSize to = size() * devicePixelRatioF();
            gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, window_->GetDisplayFramebuffer()->GetFBOIndex());
            gl.glBlitFramebuffer(0, 0, from[0], from[1], 0, 0, to.width(), to.height(), GL_COLOR_BUFFER_BIT,
                                 GL_NEAREST);
            // Opaque, whatever was drawn.
            gl.glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
            gl.glClear(GL_COLOR_BUFFER_BIT);
            gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        }
        gl.glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
    }

  private:
    /// Making it current binds Qt's framebuffer, which VTK must hear of, and not in the middle of its drawing.
    void takeContext() {
        if (!context() || context() == QOpenGLContext::currentContext()) return;
        makeCurrent();
        if (window_->GetReadyForRendering()) window_->GetState()->ResetFramebufferBindings();
    }

    void observe(unsigned long event, void (*answer)(vtkObject*, unsigned long, void*, void*)) {
        vtkNew<vtkCallbackCommand> command;
        command->SetClientData(this);
        command->SetCallback(answer);
        window_->AddObserver(event, command);
    }

    /// While the context still lives.
    void release() {
        if (!window_->GetReadyForRendering()) return;
        makeCurrent();
        window_->Finalize();
        window_->SetReadyForRendering(false);
        drawn_ = false;
        doneCurrent();
    }

    vtkNew<vtkGenericOpenGLRenderWindow> window_;
    bool drawn_ = false;
};

class NativeSurface : public ViewSurface {
  public:
    explicit NativeSurface(QWidget* parent) : widget_(new NativeWidget(parent)) {
        widget_->setCursor(Qt::ArrowCursor);
    }

    QWidget* widget() override { return widget_; }
    vtkRenderWindow& renderWindow() override { return widget_->window(); }
    bool drawFrame() override { return widget_->draw(); }

  private:
    NativeWidget* widget_;
};

}  // namespace

QSurfaceFormat nativeFormat() {
    QSurfaceFormat wanted;
    wanted.setRenderableType(QSurfaceFormat::OpenGL);
    wanted.setVersion(3, 2);
    wanted.setProfile(QSurfaceFormat::CoreProfile);
    wanted.setSwapBehavior(QSurfaceFormat::DoubleBuffer);
    wanted.setRedBufferSize(8);
    wanted.setGreenBufferSize(8);
    wanted.setBlueBufferSize(8);
    wanted.setDepthBufferSize(8);
    wanted.setAlphaBufferSize(8);
    wanted.setStencilBufferSize(0);
    wanted.setSamples(0);
    return wanted;
}

ViewSurfaceFactory nativeSurface() {
    return [](QWidget* parent) { return std::make_unique<NativeSurface>(parent); };
}

void setNativeSurfaceFormat() {
    QSurfaceFormat::setDefaultFormat(nativeFormat());
}

}  // namespace vestige
