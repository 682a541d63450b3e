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
uniform sampler2D otherPicture;
uniform sampler2D otherDepths;
uniform int mixing;          // 0, 1 the picture; 2 the other one left of the divider, 3 in tiles, 4 everywhere
uniform float divider;     // in texture coordinates
uniform float tile;        // pixels
uniform vec2 pixel;        // size of one in texture coordinates
uniform vec2 range;        // near and far plane, m
uniform int parallel;
uniform float footprint;   // m a pixel covers: at depth 1 in perspective, everywhere in parallel
uniform int eyeDome;
uniform float shade;       // of edges
uniform float darkest;
uniform float faint;       // of the other picture in a tile that has nothing there
uniform vec3 top;
uniform vec3 bottom;
uniform vec2 band;         // shares of the whole picture's height
uniform int transparent;

bool fromOther() {
    vec2 tiles = floor(vec2(texCoord.x, 1.0 - texCoord.y) / (tile * pixel));
    return mixing == 4 || (mixing == 2 && texCoord.x < divider) || (mixing == 3 && mod(tiles.x + tiles.y, 2.0) > 0.5);
}

float depthAt(bool other, vec2 place) {
    return other ? texture(otherDepths, place).r : texture(depths, place).r;
}

vec3 colorAt(bool other) {
    return other ? texture(otherPicture, texCoord).rgb : texture(picture, texCoord).rgb;
}

// Nothing here nor 4 pixels around: not just a gap between points.
bool emptyAround(bool other) {
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            if (depthAt(other, texCoord + 4.0 * vec2(x, y) * pixel) < 1.0) return false;
    return true;
}

float metres(float d) {
    return parallel == 1 ? mix(range.x, range.y, d)
                         : range.x * range.y / (range.y - d * (range.y - range.x));
}

float nearer(bool other, vec2 aside, float here, float unit) {
    float d = depthAt(other, texCoord + aside * pixel);
    return d < 1.0 ? log2(1.0 + max(0.0, here - metres(d)) / unit) : 0.0;
}

void main() {
    bool other = fromOther();
    float d = depthAt(other, texCoord);
    vec3 shown = mix(bottom, top, mix(band.x, band.y, texCoord.y));
    float cover = transparent == 1 && d >= 1.0 ? 0.0 : 1.0;
    if (d < 1.0)
        shown = colorAt(other);
    else if (mixing == 3 && depthAt(!other, texCoord) < 1.0 && emptyAround(other))
        shown = mix(shown, colorAt(!other), faint);
    if (eyeDome == 1 && d < 1.0) {
        float here = metres(d);
        float unit = 3.0 * (parallel == 1 ? footprint : footprint * here);
        float behind = nearer(other, vec2(1.0, 0.0), here, unit) + nearer(other, vec2(-1.0, 0.0), here, unit)
                     + nearer(other, vec2(0.0, 1.0), here, unit) + nearer(other, vec2(0.0, -1.0), here, unit)
                     + nearer(other, vec2(2.0, 2.0), here, unit) + nearer(other, vec2(-2.0, 2.0), here, unit)
                     + nearer(other, vec2(2.0, -2.0), here, unit)
                     + nearer(other, vec2(-2.0, -2.0), here, unit);
        shown *= max(darkest, exp(-shade * behind));
    }
    gl_FragData[0] = vec4(shown * cover, cover);
}
)";

constexpr float kFaint = 0.3F;

}  // namespace

PicturePass* PicturePass::New() {
    VTK_STANDARD_NEW_BODY(PicturePass);
}

PicturePass::PicturePass() = default;
PicturePass::~PicturePass() = default;

void PicturePass::setBackground(const Eigen::Vector3f& top, const Eigen::Vector3f& bottom, bool transparent) {
    top_ = top;
    bottom_ = bottom;
    transparent_ = transparent;
}

void PicturePass::setBand(float low, float high) {
    bandLow_ = low;
    bandHigh_ = high;
}

void PicturePass::setMix(Mix mix, float divider, int tile_px) {
    mix_ = mix;
    divider_ = divider;
    tile_px_ = tile_px;
}

void PicturePass::Picture::fit(vtkOpenGLRenderWindow& window, int width, int height) {
    if (color->GetHandle()) {
        color->Resize(width, height);
        depth->Resize(width, height);
        return;
    }
    color->SetContext(&window);
    color->Create2D(width, height, 4, VTK_UNSIGNED_CHAR, false);
    color->SetMinificationFilter(vtkTextureObject::Nearest);
    color->SetMagnificationFilter(vtkTextureObject::Nearest);
    depth->SetContext(&window);
    depth->AllocateDepth(width, height, vtkTextureObject::Float32);
    depth->SetWrapS(vtkTextureObject::ClampToEdge);
    depth->SetWrapT(vtkTextureObject::ClampToEdge);
}

void PicturePass::fit(vtkOpenGLRenderWindow& window, int width, int height) {
    const bool sameSize = width == width_ && height == height_;
    framebuffer_->SetContext(&window);
    for (int i = 0; i < (compares() ? 2 : 1); ++i) {
        if (sameSize && pictures_[i].color->GetHandle()) continue;
        pictures_[i].fit(window, width, height);
        empty_ = true;
    }
    // A picture that was left out while the size changed is made anew.
    if (!sameSize && !compares() && pictures_[1].color->GetHandle()) {
        pictures_[1].color->ReleaseGraphicsResources(&window);
        pictures_[1].depth->ReleaseGraphicsResources(&window);
    }
    if (compares() && !bothDrawn_) empty_ = true;
    bothDrawn_ = compares();
    width_ = width;
    height_ = height;
}

void PicturePass::addProps(const vtkRenderState& state, int index) {
    vtkRenderer* renderer = state.GetRenderer();
    std::vector<vtkProp*> props;
    for (int i = 0; i < state.GetPropArrayCount(); ++i)
        if (!prepare_ || prepare_(*state.GetPropArray()[i], index)) props.push_back(state.GetPropArray()[i]);
    auto* gl = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow())->GetState();
    gl->PushFramebufferBindings();
    framebuffer_->Bind();
    framebuffer_->AddColorAttachment(0, pictures_[index].color);
    framebuffer_->ActivateDrawBuffer(0);
    framebuffer_->AddDepthAttachment(pictures_[index].depth);
    framebuffer_->StartNonOrtho(width_, height_);
    gl->vtkglViewport(0, 0, width_, height_);
    gl->vtkglScissor(0, 0, width_, height_);
    gl->vtkglEnable(GL_DEPTH_TEST);
    gl->vtkglDepthMask(GL_TRUE);
    renderer->SetPreserveColorBuffer(!empty_);
    renderer->SetPreserveDepthBuffer(!empty_);
    vtkRenderState inner(renderer);
    inner.SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
    inner.SetFrameBuffer(framebuffer_);
    steps_->Render(&inner);
    NumberOfRenderedProps += steps_->GetNumberOfRenderedProps();
    gl->PopFramebufferBindings();
}

void PicturePass::show(const vtkRenderState& state, int left, int low) {
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
    // Samplers need a texture even where they are not read.
    Picture& own = pictures_[0];
    Picture& other = pictures_[compares() ? 1 : 0];
    own.color->Activate();
    own.depth->Activate();
    if (compares()) {
        other.color->Activate();
        other.depth->Activate();
    }
    program->SetUniformi("picture", own.color->GetTextureUnit());
    program->SetUniformi("depths", own.depth->GetTextureUnit());
    program->SetUniformi("otherPicture", other.color->GetTextureUnit());
    program->SetUniformi("otherDepths", other.depth->GetTextureUnit());
    program->SetUniformi("mixing", static_cast<int>(mix_));
    program->SetUniformf("divider", divider_);
    program->SetUniformf("tile", static_cast<float>(tile_px_));
    program->SetUniform2f("pixel", pixel);
    program->SetUniform2f("range", range);
    program->SetUniformi("parallel", parallel);
    program->SetUniformf("footprint", static_cast<float>(2 * halfHeight / height_));
    program->SetUniformi("eyeDome", eyeDome_);
    // On a light background a weaker shade tells shapes apart, and saves ink.
    const bool light = top_.mean() > 0.5F;
    program->SetUniformf("shade", light ? 0.05F : 0.09F);
    program->SetUniformf("darkest", light ? 0.42F : 0.18F);
    program->SetUniformf("faint", kFaint);
    program->SetUniform3f("top", top_.data());
    program->SetUniform3f("bottom", bottom_.data());
    const float band[2] = {bandLow_, bandHigh_};
    program->SetUniform2f("band", band);
    program->SetUniformi("transparent", transparent_);
    gl->vtkglViewport(left, low, width_, height_);
    gl->vtkglScissor(left, low, width_, height_);
    gl->vtkglDisable(GL_DEPTH_TEST);
    gl->vtkglDisable(GL_BLEND);
    quad_->Render();
    gl->vtkglEnable(GL_BLEND);
    gl->vtkglEnable(GL_DEPTH_TEST);
    for (int i = compares() ? 1 : 0; i >= 0; --i) {
        pictures_[i].depth->Deactivate();
        pictures_[i].color->Deactivate();
    }
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
    NumberOfRenderedProps = 0;
    for (int i = 0; i < (compares() ? 2 : 1); ++i) addProps(*state, i);
    empty_ = false;
    show(*state, left, low);
}

void PicturePass::ReleaseGraphicsResources(vtkWindow* window) {
    steps_->ReleaseGraphicsResources(window);
    framebuffer_->ReleaseGraphicsResources(window);
    for (Picture& picture : pictures_) {
        picture.color->ReleaseGraphicsResources(window);
        picture.depth->ReleaseGraphicsResources(window);
    }
    quad_.reset();
    if (release_) release_();
    width_ = height_ = 0;
    empty_ = true;
    Superclass::ReleaseGraphicsResources(window);
}

}  // namespace vestige
