#include "core/pipeline/DescribeView.h"

#include "core/pipeline/PointFlags.h"
#include "core/pipeline/TargetDistances.h"
#include "core/scene/Cleaning.h"

namespace vestige {
namespace {

Similarity placeOf(const Layer& layer, bool before) {
    return before && layer.registration ? layer.registration->initial : sceneFromLayer(layer);
}

std::shared_ptr<const std::vector<float>> residuals(const SceneState& scene, const Layer& layer, bool before,
                                                    const JobControl& control) {
    const Layer* target = scene.layer(scene.target);
    if (!target || !target->data || !layer.registration) return nullptr;
    return std::make_shared<const std::vector<float>>(
        targetDistances(*target->data->octree, sceneFromLayer(*target), *layer.data->points,
                        placeOf(layer, before), control));
}

}  // namespace

bool knowsNorth(const SceneState& scene) {
    const Layer* target = scene.layer(scene.target);
    if (!target) return false;
    if (!target->data || target->data->points->empty()) return false;
    if (!target->data->info.crs.empty()) return true;
    constexpr double kMapGrid_m = 1e4;
    const Eigen::Vector3d centre = sceneFromLayer(*target) * target->data->points->bounds().centre();
    return target->role == LayerRole::aerial && centre.head<2>().cwiseAbs().maxCoeff() >= kMapGrid_m;
}

ViewDescription describeView(const SceneState& scene, ColorMode colorMode, Overlay overlay, bool before,
                             const JobControl& control) {
    ViewDescription view;
    view.colorMode = colorMode;
    view.overlay = overlay;
    view.title = scene.name;
    for (const Layer& layer : scene.layers) {
        if (!layer.data || !layer.visible) continue;
        ViewLayer shown;
        shown.id = layer.id;
        shown.name = layer.name;
        shown.geometry = layer.data->geometry;
        shown.octree = layer.data->octree;
        shown.worldFromLayer = placeOf(layer, before);
        shown.tint = layer.tint;
        shown.isTarget = layer.id == scene.target;
        if (overlay == Overlay::residual) shown.residual_m = residuals(scene, layer, before, control);
        view.layers.push_back(std::move(shown));
    }
    return view;
}

void hideObjects(ViewDescription& view, const SceneState& scene) {
    for (ViewLayer& shown : view.layers) {
        const Layer* layer = scene.layer(shown.id);
        if (!layer || !layer->data) continue;
        std::vector<const PointSet*> sets;
        const auto hidden = hiddenSets(scene, *layer);
        for (const auto& set : hidden) sets.push_back(set.get());
        shown.hidden = pointFlags(*layer->data, sets);
    }
}

}  // namespace vestige
