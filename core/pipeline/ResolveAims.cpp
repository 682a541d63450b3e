#include "core/pipeline/ResolveAims.h"

#include <algorithm>
#include <map>
#include <optional>

#include "core/geometry/Picking.h"
#include "core/pipeline/SnapPick.h"
#include "core/scene/PickFrame.h"

namespace vestige {
namespace {

using Paths = std::map<std::string, std::optional<ScannerPath>>;

/// The scanner's path of every layer that an aim fits features on.
Paths pathsOf(const SceneState& scene, const JobControl& control) {
    Paths paths;
    for (const Measurement& measurement : scene.measurements)
        for (const auto& [method, aims] : measurement.aims)
            for (const AimedPair& pair : aims)
                for (const Aim* aim : {&pair.a, &pair.b})
                    if (aim->snap != SnapMode::point)
                        for (const std::string& id : aim->layers)
                            if (const Layer* layer = scene.layer(id); layer && !paths.contains(id))
                                paths.emplace(id, scannerPathOf(*layer, control));
    return paths;
}

/// What the click hits, with only the aim's layers shown.
std::optional<PickedPoint> resolve(const SceneState& scene, const Aim& aim, const Paths& paths) {
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
    const Layer& layer = scene.layers[pick->layer];
    std::optional<FittedFeature> fitted;
    if (aim.snap != SnapMode::point) {
        // Of the point hit only how far away it is: the analyst's eye was on the cursor.
        const ViewRay ray = camera->ray(aim.pixel);
        const Eigen::Vector3d seed =
            ray.from + ray.direction.dot(pick->world - ray.from) * ray.direction;
        const auto path = paths.find(layer.id);
        const auto feature = snapPick(layer, seed, ray.direction, aim.snap,
                                      path != paths.end() && path->second ? &*path->second : nullptr);
        if (feature) fitted = *feature;
    }
    return pickAt(scene, layer.id, pick->world, pick->localSpacing_m, fitted);
}

}  // namespace

std::vector<Measurement> resolveAims(const SceneState& scene, const JobControl& control) {
    std::vector<Measurement> measurements = scene.measurements;
    const Paths paths = pathsOf(scene, control);
    for (std::size_t i = 0; i < measurements.size(); ++i) {
        for (const auto& [method, aims] : measurements[i].aims) {
            std::vector<PickedPair> pairs;
            for (const AimedPair& aim : aims) {
                if (control.cancelled()) return scene.measurements;
                const auto a = resolve(scene, aim.a, paths);
                const auto b = resolve(scene, aim.b, paths);
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
