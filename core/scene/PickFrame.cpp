#include "core/scene/PickFrame.h"

namespace vestige {

bool isPlaced(const SceneState& scene, const Layer& layer) {
    return layer.id == scene.target || layer.registration.has_value();
}

Similarity sceneFromPick(const SceneState& scene, const PickedPoint& point) {
    const Layer* layer = scene.layer(point.layer);
    if (!layer) return {};
    if (point.inLayerFrame) return sceneFromLayer(*layer);
    const bool writtenForTarget =
        isPlaced(scene, *layer) || !std::holds_alternative<InitIdentity>(layer->init);
    return writtenForTarget ? Similarity{} : sceneFromLayer(*layer);
}

Eigen::Vector3d scenePosition(const SceneState& scene, const PickedPoint& point) {
    return sceneFromPick(scene, point) * point.position;
}

std::optional<FittedFeature> sceneFeature(const SceneState& scene, const PickedPoint& point) {
    if (!point.fitted) return std::nullopt;
    return moved(*point.fitted, sceneFromPick(scene, point));
}

bool inTargetFrame(const SceneState& scene, const PickedPoint& point) {
    const Layer* layer = scene.layer(point.layer);
    if (!layer) return false;
    if (isPlaced(scene, *layer)) return true;
    return !point.inLayerFrame && !std::holds_alternative<InitIdentity>(layer->init);
}

PickedPoint pickAt(const SceneState& scene, const std::string& layer, const Eigen::Vector3d& world_m,
                   std::optional<double> localSpacing_m, const std::optional<FittedFeature>& fitted) {
    const Layer* found = scene.layer(layer);
    if (!found || isPlaced(scene, *found)) return {layer, world_m, localSpacing_m, false, fitted};
    const Similarity layerFromScene = sceneFromLayer(*found).inverse();
    PickedPoint point{layer, layerFromScene * world_m, localSpacing_m, true};
    if (fitted) point.fitted = moved(*fitted, layerFromScene);
    return point;
}

std::optional<ViewCamera> cameraInScene(const SceneState& scene, const std::string& view) {
    const auto found = scene.views.find(view);
    if (found == scene.views.end()) return std::nullopt;
    ViewCamera camera = found->second;
    const auto frame = scene.viewFrames.find(view);
    if (frame == scene.viewFrames.end()) return camera;
    const Layer* layer = scene.layer(frame->second);
    if (!layer) return std::nullopt;
    const Similarity toScene = sceneFromLayer(*layer);
    camera.position = toScene * camera.position;
    camera.focalPoint = toScene * camera.focalPoint;
    camera.viewUp = toScene.pose.linear() * camera.viewUp;
    return camera;
}

}  // namespace vestige
