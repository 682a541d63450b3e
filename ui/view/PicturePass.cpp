#include "ui/view/PicturePass.h"

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLQuadHelper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkRenderState.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>
#include <vtkTextureObject.h>
#include <vtk_glew.h>

namespace vestige {
namespace {

constexpr const char* kShowShader = R"(//VTK::System::Dec
//VTK::Output::Dec
in vec2 texCoord;
uniform sampler2D picture;
uniform sampler2D depths;
uniform vec2 pixel;        // size of one in texture coordinates
uniform vec2 range;        // near and far plane, m
uniform int parallel;
uniform float footprint;   // m a pixel covers: at depth 1 in perspective, everywhere in parallel
uniform int eyeDome;
uniform vec3 top;
uniform vec3 bottom;

float metres(float d) {
    return parallel == 1 ? mix(range.x, range.y, d)
                         : range.x * range.y / (range.y - d * (range.y - range.x));
}

float nearer(vec2 aside, float here, float unit) {
    float d = texture(depths, texCoord + aside * pixel).r;
    return d < 1.0 ? log2(1.0 + max(0.0, here - metres(d)) / unit) : 0.0;
}

void main() {
    float d = texture(depths, texCoord).r;
    vec3 shown = d < 1.0 ? texture(picture, texCoord).rgb : mix(bottom, top, texCoord.y);
    if (eyeDome == 1 && d < 1.0) {
        float here = metres(d);
        float unit = 3.0 * (parallel == 1 ? footprint : footprint * here);
        float behind = nearer(vec2(1.0, 0.0), here, unit) + nearer(vec2(-1.0, 0.0), here, unit)
                     + nearer(vec2(0.0, 1.0), here, unit) + nearer(vec2(0.0, -1.0), here, unit)
                     + nearer(vec2(2.0, 2.0), here, unit) + nearer(vec2(-2.0, 2.0), here, unit)
                     + nearer(vec2(2.0, -2.0), here, unit) + nearer(vec2(-2.0, -2.0), here, unit);
        shown *= max(0.18, exp(-0.09 * behind));
    }
    gl_FragData[0] = vec4(shown, 1.0);
}
)";

}  // namespace

PicturePass* PicturePass::New() {
    VTK_STANDARD_NEW_BODY(PicturePass);
}

PicturePass::PicturePass() = default;
PicturePass::~PicturePass() = default;

void PicturePass::setBackground(const Eigen::Vector3f& top, const Eigen::Vector3f& bottom) {
    top_ = top;
    bottom_ = bottom;
}

void PicturePass::fit(vtkOpenGLRenderWindow& window, int width, int height) {
    if (width == width_ && height == height_ && color_->GetHandle()) return;
    if (!color_->GetHandle()) {
        color_->SetContext(&window);
        color_->Create2D(width, height, 4, VTK_UNSIGNED_CHAR, false);
        color_->SetMinificationFilter(vtkTextureObject::Nearest);
        color_->SetMagnificationFilter(vtkTextureObject::Nearest);
        depth_->SetContext(&window);
        depth_->AllocateDepth(width, height, vtkTextureObject::Float32);
        depth_->SetWrapS(vtkTextureObject::ClampToEdge);
        depth_->SetWrapT(vtkTextureObject::ClampToEdge);
        framebuffer_->SetContext(&window);
    } else {
        color_->Resize(width, height);
        depth_->Resize(width, height);
    }
    width_ = width;
    height_ = height;
    empty_ = true;
}

void PicturePass::addProps(const vtkRenderState& state) {
    vtkRenderer* renderer = state.GetRenderer();
    auto* gl = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow())->GetState();
    gl->PushFramebufferBindings();
    framebuffer_->Bind();
    framebuffer_->AddColorAttachment(0, color_);
    framebuffer_->ActivateDrawBuffer(0);
    framebuffer_->AddDepthAttachment(depth_);
    framebuffer_->StartNonOrtho(width_, height_);
    gl->vtkglViewport(0, 0, width_, height_);
    gl->vtkglScissor(0, 0, width_, height_);
    gl->vtkglEnable(GL_DEPTH_TEST);
    gl->vtkglDepthMask(GL_TRUE);
    renderer->SetPreserveColorBuffer(!empty_);
    renderer->SetPreserveDepthBuffer(!empty_);
    vtkRenderState inner(renderer);
    inner.SetPropArrayAndCount(state.GetPropArray(), state.GetPropArrayCount());
    inner.SetFrameBuffer(framebuffer_);
    steps_->Render(&inner);
    NumberOfRenderedProps = steps_->GetNumberOfRenderedProps();
    gl->PopFramebufferBindings();
    empty_ = false;
}

void PicturePass::show(const vtkRenderState& state) {
    vtkRenderer* renderer = state.GetRenderer();
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    auto* gl = window->GetState();
    if (!quad_)
        quad_ = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, kShowShader, "");
    else
        window->GetShaderCache()->ReadyShaderProgram(quad_->Program);
    vtkShaderProgram* program = quad_->Program;
    if (!program) return;
    vtkCamera* camera = renderer->GetActiveCamera();
    const bool parallel = camera->GetParallelProjection() != 0;
    const double halfHeight = parallel ? camera->GetParallelScale()
                                       : std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle()));
    const float pixel[2] = {1.0F / static_cast<float>(width_), 1.0F / static_cast<float>(height_)};
    const float range[2] = {static_cast<float>(camera->GetClippingRange()[0]),
                            static_cast<float>(camera->GetClippingRange()[1])};
    color_->Activate();
    depth_->Activate();
    program->SetUniformi("picture", color_->GetTextureUnit());
    program->SetUniformi("depths", depth_->GetTextureUnit());
    program->SetUniform2f("pixel", pixel);
    program->SetUniform2f("range", range);
    program->SetUniformi("parallel", parallel);
    program->SetUniformf("footprint", static_cast<float>(2 * halfHeight / height_));
    program->SetUniformi("eyeDome", eyeDome_);
    program->SetUniform3f("top", top_.data());
    program->SetUniform3f("bottom", bottom_.data());
    gl->vtkglViewport(0, 0, width_, height_);
    gl->vtkglScissor(0, 0, width_, height_);
    gl->vtkglDisable(GL_DEPTH_TEST);
    gl->vtkglDisable(GL_BLEND);
    quad_->Render();
    gl->vtkglEnable(GL_BLEND);
    gl->vtkglEnable(GL_DEPTH_TEST);
    depth_->Deactivate();
    color_->Deactivate();
}

void PicturePass::Render(const vtkRenderState* state) {
    vtkRenderer* renderer = state->GetRenderer();
    int width = 0;
    int height = 0;
    int left = 0;
    int low = 0;
    renderer->GetTiledSizeAndOrigin(&width, &height, &left, &low);
    if (width < 1 || height < 1) return;
    fit(*vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()), width, height);
    addProps(*state);
    show(*state);
}

void PicturePass::ReleaseGraphicsResources(vtkWindow* window) {
    steps_->ReleaseGraphicsResources(window);
    framebuffer_->ReleaseGraphicsResources(window);
    color_->ReleaseGraphicsResources(window);
    depth_->ReleaseGraphicsResources(window);
    quad_.reset();
    width_ = height_ = 0;
    empty_ = true;
    Superclass::ReleaseGraphicsResources(window);
}

}  // namespace vestige
