#include "core/pipeline/ResolveAims.h"

#include <algorithm>

#include "core/geometry/Picking.h"
#include "core/scene/PickFrame.h"

namespace vestige {
namespace {

/// What the click hits, with only the aim's layers shown.
std::optional<PickedPoint> resolve(const SceneState& scene, const Aim& aim) {
    const auto camera = cameraInScene(scene, aim.view);
    if (!camera) return std::nullopt;
    std::vector<PickLayer> shown;
    for (std::size_t i = 0; i < scene.layers.size(); ++i) {
        const Layer& layer = scene.layers[i];
        if (!layer.data || std::find(aim.layers.begin(), aim.layers.end(), layer.id) == aim.layers.end())
            continue;
        shown.push_back({static_cast<std::uint32_t>(i), layer.data->octree.get(), sceneFromLayer(layer)});
    }
    const auto pick = pickPoint(shown, *camera, aim.pixel);
    if (!pick) return std::nullopt;
    return pickAt(scene, scene.layers[pick->layer].id, pick->world, pick->localSpacing_m);
}

}  // namespace

std::vector<Measurement> resolveAims(const SceneState& scene, const JobControl& control) {
    std::vector<Measurement> measurements = scene.measurements;
    for (std::size_t i = 0; i < measurements.size(); ++i) {
        for (const auto& [method, aims] : measurements[i].aims) {
            std::vector<PickedPair> pairs;
            for (const AimedPair& aim : aims) {
                if (control.cancelled()) return scene.measurements;
                const auto a = resolve(scene, aim.a);
                const auto b = resolve(scene, aim.b);
                if (a && b) pairs.push_back({*a, *b});
            }
            if (pairs.empty())
                measurements[i].picks.erase(method);
            else
                measurements[i].picks[method] = std::move(pairs);
        }
        control.progress(static_cast<double>(i + 1) / static_cast<double>(measurements.size()), "aims");
    }
    return measurements;
}

}  // namespace vestige
