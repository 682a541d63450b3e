#include "ui/view/SceneDrawing.h"

#include <vtkActor.h>
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
#include "ui/view/VtkCamera.h"

namespace vestige {
namespace {

/// What the colours of a layer's points depend on.
struct ColorKey {
    ColorMode mode;
    Overlay overlay;
    Rgb tint;
    std::shared_ptr<const std::vector<float>> residuals;
    double low;
    double high;
    bool operator==(const ColorKey&) const = default;
};

/// A layer in the VTK scene: a point prop or a mesh actor.
struct Drawn {
    std::shared_ptr<const TriangleMesh> geometry;
    Similarity worldFromLayer;
    BoundingBox box;  ///< world
    vtkSmartPointer<PointProp> points;
    std::vector<std::uint32_t> order;
    vtkSmartPointer<vtkActor> mesh;
    std::optional<ColorKey> colors;
    bool visible = false;
    std::size_t seen = 0;

    bool holds(const ViewLayer& layer) const {
        return geometry == layer.geometry && worldFromLayer.scale == layer.worldFromLayer.scale &&
               worldFromLayer.pose.matrix() == layer.worldFromLayer.pose.matrix();
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

    explicit Private(vtkRenderWindow& shown) : window(shown) {}

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
        drawn.worldFromLayer = layer.worldFromLayer;
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

    void color(Drawn& drawn, const ViewDescription& view, std::size_t index) {
        const ViewLayer& layer = view.layers[index];
        const ColorKey key{view.colorMode,   view.overlay,           layerTint(view, index),
                           layer.residual_m, scale ? scale->low : 0, scale ? scale->high : 0};
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
                                        [&](const Drawn& drawn) { return drawn.holds(layer); });
        if (known != before.end()) {
            d_->layers.push_back(std::move(*known));
            before.erase(known);
        } else {
            d_->layers.push_back(d_->add(layer, i < octrees.size() ? octrees[i].get() : nullptr));
        }
        Drawn& drawn = d_->layers.back();
        if (!drawn.prop()) continue;
        drawn.visible = layer.visible;
        drawn.prop()->SetVisibility(layer.visible);
        if (layer.visible) d_->color(drawn, view, i);
        if (drawn.points) drawn.points->setPointSize(view.pointSize_px);
    }
    for (const Drawn& drawn : before) d_->remove(drawn);
    d_->pass->setEyeDomeLighting(view.eyeDomeLighting);
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
        if (drawn.mesh) {
            include(depthsSeen(camera, drawn.box.min, drawn.box.max));
            continue;
        }
        const std::vector<PointBlock>& blocks = drawn.points->blocks();
        std::vector<bool> seen(blocks.size());
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            const auto depths = depthsSeen(camera, d_->origin + blocks[i].min.cast<double>(),
                                           d_->origin + blocks[i].max.cast<double>());
            include(depths);
            seen[i] = depths.has_value();
            if (depths) drawn.seen += blocks[i].size();
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
