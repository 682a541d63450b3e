#include "ui/view/SceneDrawing.h"

#include <vtkActor.h>
#include <vtkCullerCollection.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>

#include "core/pipeline/FrameView.h"
#include "ui/view/MeshActor.h"
#include "ui/view/PicturePass.h"
#include "ui/view/PointColors.h"
#include "ui/view/PointProp.h"
#include "ui/view/ViewTheme.h"
#include "ui/view/VtkCamera.h"

namespace vestige {
namespace {

/// What the colours of a layer's points depend on.
struct ColorKey {
    ColorMode mode;
    Overlay overlay;
    Theme theme;
    Rgb tint;
    std::shared_ptr<const std::vector<float>> residuals;
    double low;
    double high;
    std::optional<std::array<double, 16>> pose;  ///< where colours are by height
    bool operator==(const ColorKey&) const = default;
};

bool byHeight(const ViewDescription& view) {
    return view.overlay == Overlay::none && view.colorMode == ColorMode::height;
}

/// Moved in the display frame, points keep their digits while they are this near to its origin, metres.
constexpr double kNearOrigin_m = 1000;
constexpr double kLeastPull_m = 0.1;  // over the noise of a target from the air
constexpr double kMostPull_m = 0.4;

Eigen::Vector3f toVector(const QColor& color) {
    return {static_cast<float>(color.redF()), static_cast<float>(color.greenF()),
            static_cast<float>(color.blueF())};
}

bool samePlace(const Similarity& a, const Similarity& b) {
    return a.scale == b.scale && a.pose.matrix() == b.pose.matrix();
}

/// A layer in the VTK scene: a point prop or a mesh actor.
struct Drawn {
    std::shared_ptr<const TriangleMesh> geometry;
    Similarity built;  ///< worldFromLayer that the positions were made with
    BoundingBox box;   ///< world, as built
    std::array<ViewSide, 2> sides;
    vtkSmartPointer<PointProp> points;
    std::vector<std::uint32_t> order;
    vtkSmartPointer<vtkActor> mesh;
    std::optional<ColorKey> colors;
    bool visible = false;
    std::size_t seen = 0;

    /// World motion from where it was built to where it lies in a picture.
    Similarity motion(int picture) const {
        const Similarity& wanted = sides[picture].worldFromLayer;
        if (samePlace(wanted, built)) return {};
        return {wanted.pose * built.pose.inverse(), wanted.scale / built.scale};
    }
    vtkProp* prop() const { return points ? static_cast<vtkProp*>(points) : mesh; }
};

}  // namespace

struct SceneDrawing::Private {
    vtkRenderWindow& window;
    vtkNew<vtkOpenGLRenderer> renderer;
    vtkNew<PicturePass> pass;
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< world; of everything in the VTK scene
    std::vector<Drawn> layers;                         ///< as in the description
    std::optional<ColorScale> scale;
    double share = 0;
    bool compares = false;

    explicit Private(vtkRenderWindow& shown) : window(shown) {}

    bool nearOrigin(const BoundingBox& box) const {
        return (box.centre() - origin).norm() + box.diagonal() < kNearOrigin_m;
    }

    /// Whether `drawn` can show the layer without being built again.
    bool holds(const Drawn& drawn, const ViewLayer& layer) const {
        if (drawn.geometry != layer.geometry) return false;
        if (samePlace(drawn.built, layer.worldFromLayer)) return true;
        const Similarity motion{layer.worldFromLayer.pose * drawn.built.pose.inverse(), 1};
        return drawn.built.scale == layer.worldFromLayer.scale && nearOrigin(drawn.box) &&
               nearOrigin(drawn.box.transformed(motion));
    }

    /// Moves what a prop shows to where it lies in one of the two pictures.
    bool prepare(vtkProp& prop, int picture) {
        const auto found = std::find_if(layers.begin(), layers.end(),
                                        [&](const Drawn& drawn) { return drawn.prop() == &prop; });
        if (found == layers.end() || !found->sides[picture].visible) return false;
        const Similarity motion = found->motion(picture);
        Eigen::Matrix4d display = Eigen::Matrix4d::Identity();
        display.topLeftCorner<3, 3>() = motion.scale * motion.pose.linear();
        display.topRightCorner<3, 1>() = motion * origin - origin;
        if (motion.isIdentity()) display.setIdentity();
        if (found->points) {
            found->points->setMotion(display.cast<float>());
        } else {
            vtkNew<vtkMatrix4x4> matrix;
            for (int i = 0; i < 16; ++i) matrix->SetElement(i / 4, i % 4, display(i / 4, i % 4));
            found->mesh->SetUserMatrix(matrix);
        }
        return true;
    }

    void placeOrigin(const ViewDescription& view) {
        const BoundingBox box = subjectBounds(view);
        if (box.empty()) return;
        const bool near = (origin - box.centre()).norm() <= std::max(100.0, box.diagonal());
        if (near && !layers.empty()) return;
        clear();
        origin = box.centre().array().round();
    }

    void clear() {
        for (const Drawn& drawn : layers) remove(drawn);
        layers.clear();
    }

    void remove(const Drawn& drawn) {
        if (drawn.prop()) renderer->RemoveViewProp(drawn.prop());
    }

    Drawn add(const ViewLayer& layer, const Octree* octree) {
        Drawn drawn;
        drawn.geometry = layer.geometry;
        drawn.built = layer.worldFromLayer;
        if (!layer.geometry || layer.geometry->vertices.empty()) return drawn;
        drawn.box = layer.geometry->vertices.bounds().transformed(layer.worldFromLayer);
        if (layer.geometry->isMesh()) {
            drawn.mesh = makeMeshActor(*layer.geometry, layer.worldFromLayer, origin);
        } else {
            const PointCloud& cloud = layer.geometry->vertices;
            const bool usable = octree && &octree->cloud() == &cloud;
            PointBlocks blocks = makePointBlocks(cloud, layer.worldFromLayer, origin,
                                                 usable ? octree->order() : std::span<const std::uint32_t>{});
            drawn.points = vtkSmartPointer<PointProp>::New();
            drawn.points->setPositions(std::move(blocks.positions), std::move(blocks.blocks),
                                       blocks.spacing_m);
            drawn.order = std::move(blocks.order);
        }
        renderer->AddViewProp(drawn.prop());
        return drawn;
    }

    /// Half of what is coloured by its distance lies behind the target's surface; it is drawn as if it lay
    /// before it, or one sign of the distances would be hidden.
    double pullOf(const ViewDescription& view, const ViewLayer& layer) const {
        if (view.overlay != Overlay::residual || !layer.residual_m || !scale) return 0;
        return std::clamp(4 * scale->high, kLeastPull_m, kMostPull_m);
    }

    void color(Drawn& drawn, const ViewDescription& view, std::size_t index) {
        const ViewLayer& layer = view.layers[index];
        const ColorKey key{
            view.colorMode,
            view.overlay,
            view.theme,
            layerTint(view, index),
            layer.residual_m,
            scale ? scale->low : 0,
            scale ? scale->high : 0,
            byHeight(view) ? std::optional(rowMajor(layer.worldFromLayer.pose)) : std::nullopt};
        if (drawn.colors == key) return;
        drawn.colors = key;
        const std::vector<Rgba> colors = pointColors(view, index, scale);
        if (drawn.mesh) return setVertexColors(*drawn.mesh, colors);
        std::vector<Rgba> ordered(colors.size());
        for (std::size_t i = 0; i < ordered.size(); ++i) ordered[i] = colors[drawn.order[i]];
        drawn.points->setColors(std::move(ordered));
    }
};

SceneDrawing::SceneDrawing(vtkRenderWindow& window) : d_(std::make_unique<Private>(window)) {
    d_->renderer->SetPass(d_->pass);
    d_->renderer->SetBackground(0, 0, 0);
    // VTK would leave out what the first picture does not show; setCamera() decides for both.
    d_->renderer->GetCullers()->RemoveAllItems();
    d_->pass->setPrepare([this](vtkProp& prop, int picture) { return d_->prepare(prop, picture); });
    window.AddRenderer(d_->renderer);
}

SceneDrawing::~SceneDrawing() {
    d_->window.RemoveRenderer(d_->renderer);
}

void SceneDrawing::show(const ViewDescription& view,
                        const std::vector<std::shared_ptr<const Octree>>& octrees) {
    d_->placeOrigin(view);
    d_->scale = colorScale(view);
    std::vector<Drawn> before = std::move(d_->layers);
    d_->layers.clear();
    for (std::size_t i = 0; i < view.layers.size(); ++i) {
        const ViewLayer& layer = view.layers[i];
        const auto known = std::find_if(before.begin(), before.end(),
                                        [&](const Drawn& drawn) { return d_->holds(drawn, layer); });
        if (known != before.end()) {
            d_->layers.push_back(std::move(*known));
            before.erase(known);
        } else {
            d_->layers.push_back(d_->add(layer, i < octrees.size() ? octrees[i].get() : nullptr));
        }
        Drawn& drawn = d_->layers.back();
        if (!drawn.prop()) continue;
        const ViewSide own{layer.worldFromLayer, layer.visible};
        drawn.sides = {own,
                       view.comparison ? layer.other.value_or(own) : ViewSide{own.worldFromLayer, false}};
        drawn.visible = drawn.sides[0].visible || drawn.sides[1].visible;
        drawn.prop()->SetVisibility(drawn.visible);
        if (drawn.visible) d_->color(drawn, view, i);
        if (drawn.points) {
            drawn.points->setPointSize(view.pointSize_px);
            drawn.points->setPull(d_->pullOf(view, layer));
        }
    }
    for (const Drawn& drawn : before) d_->remove(drawn);
    d_->pass->setEyeDomeLighting(view.eyeDomeLighting);
    const ViewTheme theme = viewTheme(view.theme);
    d_->pass->setBackground(toVector(theme.backgroundTop), toVector(theme.backgroundBottom));
    d_->compares = view.comparison.has_value();
    if (view.comparison)
        setComparison(*view.comparison);
    else
        d_->pass->setMix(PicturePass::Mix::none, 0, 1);
}

void SceneDrawing::setComparison(const ViewComparison& comparison) {
    if (!d_->compares) return;
    using Mix = PicturePass::Mix;
    const Mix mix = comparison.mode == CompareMode::swipe          ? Mix::swipe
                    : comparison.mode == CompareMode::checkerboard ? Mix::checkerboard
                    : comparison.otherShown                        ? Mix::other
                                                                   : Mix::own;
    d_->pass->setMix(mix, static_cast<float>(comparison.divider), comparison.tile_px);
}

void SceneDrawing::setCamera(const ViewCamera& camera) {
    std::optional<DepthRange> range;
    const auto include = [&](const std::optional<DepthRange>& one) {
        if (!one) return;
        range = range ? DepthRange{std::min(range->nearest, one->nearest),
                                   std::max(range->farthest, one->farthest)}
                      : one;
    };
    for (Drawn& drawn : d_->layers) {
        drawn.seen = 0;
        if (!drawn.visible) continue;
        std::vector<Similarity> motions;
        for (int picture = 0; picture < 2; ++picture)
            if (drawn.sides[picture].visible) motions.push_back(drawn.motion(picture));
        const auto depths = [&](const BoundingBox& built) {
            bool shown = false;
            for (const Similarity& motion : motions) {
                const BoundingBox box = motion.isIdentity() ? built : built.transformed(motion);
                const auto seen = depthsSeen(camera, box.min, box.max);
                include(seen);
                shown = shown || seen;
            }
            return shown;
        };
        if (drawn.mesh) {
            depths(drawn.box);
            continue;
        }
        const std::vector<PointBlock>& blocks = drawn.points->blocks();
        std::vector<bool> seen(blocks.size());
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            seen[i] = depths(
                {d_->origin + blocks[i].min.cast<double>(), d_->origin + blocks[i].max.cast<double>()});
            if (seen[i]) drawn.seen += blocks[i].size();
        }
        drawn.points->setSeen(std::move(seen));
    }
    setVtkCamera(*d_->renderer->GetActiveCamera(), camera, d_->origin, range.value_or(DepthRange{1, 2}));
}

std::size_t SceneDrawing::pointsSeen() const {
    std::size_t sum = 0;
    for (const Drawn& drawn : d_->layers) sum += drawn.seen;
    return sum;
}

void SceneDrawing::beginPicture(double share) {
    d_->pass->restart();
    d_->share = share;
    for (const Drawn& drawn : d_->layers) {
        if (drawn.points) drawn.points->setPart(0, share);
        if (drawn.mesh) drawn.mesh->SetVisibility(drawn.visible);
    }
}

void SceneDrawing::addToPicture(double share) {
    for (const Drawn& drawn : d_->layers) {
        if (drawn.points) drawn.points->setPart(d_->share, share);
        if (drawn.mesh) drawn.mesh->SetVisibility(false);
    }
    d_->share = share;
}

const std::optional<ColorScale>& SceneDrawing::scale() const {
    return d_->scale;
}

}  // namespace vestige
