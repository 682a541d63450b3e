#include "ui/view/PointProp.h"

#include <vtkMath.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLCamera.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>
#include <vtk_glew.h>

#include <cmath>

namespace vestige {
namespace {

constexpr const char* kVertexShader = R"(//VTK::System::Dec
in vec3 place;
in vec4 paint;
out vec4 color;
flat out float size;
uniform mat4 clipFromDisplay;
uniform mat4 motion;
uniform float pointSize;
uniform float spacing;    // pixels between neighbours, times depth in perspective
uniform float pull;       // how much nearer to the camera, m
uniform vec2 range;       // near and far plane, m
uniform int parallel;
void main() {
    color = paint;
    gl_Position = clipFromDisplay * (motion * vec4(place, 1.0));
    if (parallel == 1) {
        gl_Position.z -= 2.0 * pull / (range.y - range.x);
    } else if (pull > 0.0 && gl_Position.w > range.x) {
        // Depth is A + B / w; that of w less the pull, but not before the near plane.
        float b = -2.0 * range.x * range.y / (range.y - range.x);
        float nearer = min(pull, 0.9 * (gl_Position.w - range.x));
        gl_Position.z += b * nearer / (gl_Position.w - nearer);
    }
    size = clamp(spacing / gl_Position.w, pointSize, 2.5 * pointSize);
    gl_PointSize = size;
}
)";

constexpr const char* kFragmentShader = R"(//VTK::System::Dec
//VTK::Output::Dec
in vec4 color;
flat in float size;
void main() {
    vec2 aside = gl_PointCoord - vec2(0.5);
    if (size >= 3.0 && dot(aside, aside) > 0.25) discard;   // round, once that shows
    gl_FragData[0] = color;
}
)";

}  // namespace

PointProp* PointProp::New() {
    VTK_STANDARD_NEW_BODY(PointProp);
}

void PointProp::setPositions(std::vector<Eigen::Vector3f> positions, std::vector<PointBlock> blocks,
                             double spacing_m) {
    spacing_m_ = spacing_m;
    positions_ = std::move(positions);
    blocks_ = std::move(blocks);
    seen_.assign(blocks_.size(), true);
    for (int axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < blocks_.size(); ++i) {
            const double low = blocks_[i].min[axis];
            const double high = blocks_[i].max[axis];
            bounds_[2 * axis] = i ? std::min(bounds_[2 * axis], low) : low;
            bounds_[2 * axis + 1] = i ? std::max(bounds_[2 * axis + 1], high) : high;
        }
    }
    Modified();
}

void PointProp::setColors(std::vector<Rgba> colors) {
    colors_ = std::move(colors);
    Modified();
}

void PointProp::setPart(double from, double to) {
    from_ = from;
    to_ = to;
}

void PointProp::upload() {
    if (!positions_.empty()) {
        positionBuffer_->Upload(positions_, vtkOpenGLBufferObject::ArrayBuffer);
        positions_ = {};
        attributesBound_ = false;
    }
    if (!colors_.empty()) {
        colorBuffer_->Upload(colors_, vtkOpenGLBufferObject::ArrayBuffer);
        colors_ = {};
        attributesBound_ = false;
    }
}

int PointProp::RenderOpaqueGeometry(vtkViewport* viewport) {
    if (blocks_.empty() || from_ >= to_) return 0;
    auto* renderer = vtkRenderer::SafeDownCast(viewport);
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    upload();
    if (!positionBuffer_->IsReady() || !colorBuffer_->IsReady()) return 0;

    vtkShaderProgram* program =
        window->GetShaderCache()->ReadyShaderProgram(kVertexShader, kFragmentShader, "");
    if (!program) return 0;
    if (program != boundProgram_ || !attributesBound_) {
        arrays_->ShaderProgramChanged();
        arrays_->Bind();
        attributesBound_ = arrays_->AddAttributeArray(program, positionBuffer_, "place", 0,
                                                      sizeof(Eigen::Vector3f), VTK_FLOAT, 3, false) &&
                           arrays_->AddAttributeArray(program, colorBuffer_, "paint", 0, sizeof(Rgba),
                                                      VTK_UNSIGNED_CHAR, 4, true);
        boundProgram_ = program;
    }
    arrays_->Bind();
    vtkMatrix4x4* viewFromDisplay = nullptr;
    vtkMatrix3x3* normals = nullptr;
    vtkMatrix4x4* clipFromView = nullptr;
    vtkMatrix4x4* clipFromDisplay = nullptr;
    vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera())
        ->GetKeyMatrices(renderer, viewFromDisplay, normals, clipFromView, clipFromDisplay);
    program->SetUniformMatrix("clipFromDisplay", clipFromDisplay);
    program->SetUniformMatrix4x4("motion", motion_.data());
    vtkCamera* camera = renderer->GetActiveCamera();
    const double halfHeight = camera->GetParallelProjection()
                                  ? camera->GetParallelScale()
                                  : std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle()));
    const float range[2] = {static_cast<float>(camera->GetClippingRange()[0]),
                            static_cast<float>(camera->GetClippingRange()[1])};
    program->SetUniform2f("range", range);
    program->SetUniformi("parallel", camera->GetParallelProjection() != 0);
    program->SetUniformf("pull", static_cast<float>(pull_m_));
    program->SetUniformf("pointSize", static_cast<float>(pointSize_));
    program->SetUniformf("spacing",
                         static_cast<float>(spacing_m_ * 0.5 * renderer->GetSize()[1] / halfHeight));
    glEnable(GL_PROGRAM_POINT_SIZE);

    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        if (!seen_[i]) continue;
        const auto first = static_cast<GLint>(std::ceil(from_ * blocks_[i].size()));
        const auto last = static_cast<GLint>(std::ceil(to_ * blocks_[i].size()));
        if (first < last) glDrawArrays(GL_POINTS, static_cast<GLint>(blocks_[i].begin) + first, last - first);
    }
    glDisable(GL_PROGRAM_POINT_SIZE);
    arrays_->Release();
    return 1;
}

void PointProp::ReleaseGraphicsResources(vtkWindow* window) {
    positionBuffer_->ReleaseGraphicsResources();
    colorBuffer_->ReleaseGraphicsResources();
    arrays_->ReleaseGraphicsResources();
    boundProgram_ = nullptr;
    attributesBound_ = false;
    Superclass::ReleaseGraphicsResources(window);
}

}  // namespace vestige
