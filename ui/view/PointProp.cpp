#include "ui/view/PointProp.h"

#include <vtkMath.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLCamera.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>
#include <vtk_glew.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/Parallel.h"

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
uniform float reference;  // depth at which points have their size, m; 0: everywhere
uniform vec4 clips[6];
uniform int clipCount;
uniform int clipInverted;
void main() {
    color = paint;
    vec4 moved = motion * vec4(place, 1.0);
    int inside = 1;
    for (int i = 0; i < clipCount; ++i)
        if (dot(clips[i], moved) < 0.0) inside = 0;
    if (clipCount > 0 && inside == clipInverted) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);   // outside of every picture
        gl_PointSize = 1.0;
        size = 1.0;
        return;
    }
    gl_Position = clipFromDisplay * moved;
    float here = pointSize;
    if (reference > 0.0 && gl_Position.w > 0.0)
        here = clamp(pointSize * reference / gl_Position.w, min(1.0, pointSize), 4.0 * pointSize);
    if (parallel == 1) {
        gl_Position.z -= 2.0 * pull / (range.y - range.x);
    } else if (pull > 0.0 && gl_Position.w > range.x) {
        // Depth is A + B / w; that of w less the pull, but not before the near plane.
        float b = -2.0 * range.x * range.y / (range.y - range.x);
        float nearer = min(pull, 0.9 * (gl_Position.w - range.x));
        gl_Position.z += b * nearer / (gl_Position.w - nearer);
    }
    size = clamp(spacing / gl_Position.w, here, 2.5 * here);
    gl_PointSize = size;
}
)";

constexpr const char* kFragmentShader = R"(//VTK::System::Dec
//VTK::Output::Dec
in vec4 color;
flat in float size;
void main() {
    if (color.a < 0.5) discard;  // hidden
    vec2 aside = gl_PointCoord - vec2(0.5);
    if (size >= 3.0 && dot(aside, aside) > 0.25) discard;   // round, once that shows
    gl_FragData[0] = color;
}
)";

constexpr std::size_t kPagesAtOnce = 8;  // for a thread
constexpr std::size_t kMostClips = 6;

struct PageRange {
    std::uint32_t first;
    std::uint32_t last;
};

PageRange pageRange(const RankRange& ranks) {
    if (ranks.first >= ranks.last) return {0, 0};
    return {ranks.first / PointStore::kPage, (ranks.last - 1) / PointStore::kPage + 1};
}

}  // namespace

RankRange rankRange(std::uint32_t wanted, double from, double to) {
    return {static_cast<std::uint32_t>(std::ceil(from * wanted)),
            static_cast<std::uint32_t>(std::ceil(to * wanted))};
}

PointProp* PointProp::New() {
    VTK_STANDARD_NEW_BODY(PointProp);
}

PointProp::~PointProp() {
    if (store_) store_->drop(places_);
}

void PointProp::setPoints(std::shared_ptr<const PointCloud> cloud, PointBlocks blocks,
                          const Similarity& worldFromLayer, const Eigen::Vector3d& displayOrigin,
                          std::shared_ptr<PointStore> store) {
    cloud_ = std::move(cloud);
    blocks_ = std::move(blocks);
    worldFromLayer_ = worldFromLayer;
    displayOrigin_ = displayOrigin;
    store_ = std::move(store);
    places_.assign(placeOf(blocks_.blocks().size(), 0), PointStore::kNowhere);
    wanted_.assign(blocks_.blocks().size(), 0);
    BoundingBox box;
    for (const PointBlock& block : blocks_.blocks()) box.add(block.box);
    for (int axis = 0; axis < 3 && !box.empty(); ++axis) {
        bounds_[2 * axis] = box.min[axis] - displayOrigin_[axis];
        bounds_[2 * axis + 1] = box.max[axis] - displayOrigin_[axis];
    }
    Modified();
}

void PointProp::setPainter(PointPainter painter) {
    painter_ = std::move(painter);
    store_->drop(places_);
    Modified();
}

void PointProp::setPart(double from, double to, bool whole) {
    from_ = from;
    to_ = to;
    whole_ = whole;
}

bool PointProp::needsPage(std::size_t block, std::uint32_t page, double from, double to) const {
    const RankRange ranks = rankRange(wanted_[block], from, to);
    return ranks.first < ranks.last && page * PointStore::kPage < ranks.last &&
           (page + 1) * PointStore::kPage > ranks.first;
}

bool PointProp::bring(const std::vector<Page>& pages) {
    std::vector<std::pair<Page, std::uint32_t>> placed;
    placed.reserve(pages.size());
    for (const Page& page : pages) {
        const std::uint32_t number = store_->add(places_, placeOf(page.block, page.page));
        if (number == PointStore::kNowhere) break;
        placed.emplace_back(page, number);
    }
    parallelFor(placed.size(), kPagesAtOnce, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto& [page, number] = placed[i];
            PointVertex* vertex = store_->staged(number);
            const std::uint32_t first = page.page * PointStore::kPage;
            const std::uint32_t last =
                std::min(first + PointStore::kPage, blocks_.blocks()[page.block].size());
            for (std::uint32_t rank = first; rank < last; ++rank, ++vertex) {
                const std::uint32_t point = blocks_.point(page.block, rank);
                vertex->place = (worldFromLayer_ * cloud_->point(point) - displayOrigin_).cast<float>();
                vertex->paint = painter_(point);
            }
        }
    });
    return placed.size() == pages.size();
}

std::size_t PointProp::pagesMissing(double from, double to) const {
    std::size_t missing = 0;
    for (std::size_t block = 0; block < wanted_.size(); ++block) {
        const PageRange pages = pageRange(rankRange(wanted_[block], from, to));
        for (std::uint32_t page = pages.first; page < pages.last; ++page)
            if (places_[placeOf(block, page)] == PointStore::kNowhere) ++missing;
    }
    return missing;
}

std::size_t PointProp::endOfBatch(std::size_t first) const {
    std::size_t pages = 0;
    std::size_t block = first;
    for (; block < wanted_.size(); ++block) {
        const PageRange range = pageRange(rankRange(wanted_[block], from_, to_));
        pages += range.last - range.first;
        if (pages > store_->capacity() && block > first) break;
    }
    return block;
}

void PointProp::drawBlocks(std::size_t first, std::size_t last) const {
    std::vector<GLint> begins;
    std::vector<GLsizei> counts;
    for (std::size_t block = first; block < last; ++block) {
        const RankRange ranks = rankRange(wanted_[block], from_, to_);
        for (std::uint32_t rank = ranks.first; rank < ranks.last;) {
            const std::uint32_t page = rank / PointStore::kPage;
            const std::uint32_t next = std::min(ranks.last, (page + 1) * PointStore::kPage);
            const std::uint32_t place = places_[placeOf(block, page)];
            if (place != PointStore::kNowhere) {
                const auto begin = static_cast<GLint>(place * PointStore::kPage + rank % PointStore::kPage);
                const auto count = static_cast<GLsizei>(next - rank);
                if (!begins.empty() && begins.back() + counts.back() == begin) {
                    counts.back() += count;
                } else {
                    begins.push_back(begin);
                    counts.push_back(count);
                }
            }
            rank = next;
        }
    }
    if (!begins.empty())
        glMultiDrawArrays(GL_POINTS, begins.data(), counts.data(), static_cast<GLsizei>(begins.size()));
}

void PointProp::setUniforms(vtkShaderProgram& program, vtkRenderer& renderer) const {
    vtkMatrix4x4* viewFromDisplay = nullptr;
    vtkMatrix3x3* normals = nullptr;
    vtkMatrix4x4* clipFromView = nullptr;
    vtkMatrix4x4* clipFromDisplay = nullptr;
    vtkCamera* camera = renderer.GetActiveCamera();
    vtkOpenGLCamera::SafeDownCast(camera)->GetKeyMatrices(&renderer, viewFromDisplay, normals, clipFromView,
                                                          clipFromDisplay);
    program.SetUniformMatrix("clipFromDisplay", clipFromDisplay);
    Eigen::Matrix4f motion = motion_;
    program.SetUniformMatrix4x4("motion", motion.data());
    const double halfHeight = camera->GetParallelProjection()
                                  ? camera->GetParallelScale()
                                  : std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle()));
    const float range[2] = {static_cast<float>(camera->GetClippingRange()[0]),
                            static_cast<float>(camera->GetClippingRange()[1])};
    program.SetUniform2f("range", range);
    program.SetUniformi("parallel", camera->GetParallelProjection() != 0);
    program.SetUniformf("pull", static_cast<float>(pull_m_));
    program.SetUniformf("pointSize", static_cast<float>(pointSize_));
    const bool byDistance = sizeByDistance_ && camera->GetParallelProjection() == 0;
    program.SetUniformf("reference", byDistance ? static_cast<float>(camera->GetDistance()) : 0.0F);
    float clips[kMostClips][4] = {};
    const std::size_t count = std::min(clips_.size(), kMostClips);
    for (std::size_t i = 0; i < count; ++i) std::copy_n(clips_[i].data(), 4, clips[i]);
    program.SetUniform4fv("clips", static_cast<int>(kMostClips), clips);
    program.SetUniformi("clipCount", static_cast<int>(count));
    program.SetUniformi("clipInverted", invertClips_ ? 1 : 0);
    program.SetUniformf("spacing",
                        static_cast<float>(blocks_.spacing_m() * 0.5 * renderer.GetSize()[1] / halfHeight));
}

int PointProp::RenderOpaqueGeometry(vtkViewport* viewport) {
    if (blocks().empty() || from_ >= to_) return 0;
    auto* renderer = vtkRenderer::SafeDownCast(viewport);
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    vtkShaderProgram* program =
        window->GetShaderCache()->ReadyShaderProgram(kVertexShader, kFragmentShader, "");
    if (!program) return 0;
    setUniforms(*program, *renderer);
    glEnable(GL_PROGRAM_POINT_SIZE);
    // Blocks in their order, whatever the store holds: pictures must not depend on what was drawn before.
    for (std::size_t first = 0; first < wanted_.size();) {
        const std::size_t last = whole_ ? endOfBatch(first) : wanted_.size();
        if (whole_) {
            store_->begin();
            std::vector<Page> missing;
            for (std::size_t block = first; block < last; ++block) {
                const PageRange range = pageRange(rankRange(wanted_[block], from_, to_));
                for (std::uint32_t page = range.first; page < range.last; ++page)
                    if (!touchPage(block, page)) missing.push_back({block, page});
            }
            bring(missing);
        }
        store_->bind(*program);
        drawBlocks(first, last);
        first = last;
    }
    glDisable(GL_PROGRAM_POINT_SIZE);
    store_->unbind();
    return 1;
}

void PointProp::ReleaseGraphicsResources(vtkWindow* window) {
    // VTK calls this when the prop is removed, too, and the store has the other layers' pages.
    if (store_ && !keepPages_) store_->drop(places_);
    Superclass::ReleaseGraphicsResources(window);
}

}  // namespace vestige
