#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>

#include "core/scene/Scene.h"

namespace vestige {

/// True when the layer has its place in the scene: it is the target, or registered to it.
bool isPlaced(const SceneState& scene, const Layer& layer);

/// Maps PickedPoint::position to scene metres. Positions of the target and of layers registered to it are
/// there already; so are those of a layer that the case gives a first pose for, since they were written for
/// the time after its registration. Of other layers, and of points marked inLayerFrame, it is sceneFromLayer.
Similarity sceneFromPick(const SceneState& scene, const PickedPoint& point);

/// Where the picked point lies in the scene, metres.
Eigen::Vector3d scenePosition(const SceneState& scene, const PickedPoint& point);

/// True when scenePosition is in the target's frame, so that lengths to points of other layers mean
/// something.
bool inTargetFrame(const SceneState& scene, const PickedPoint& point);

/// What was fitted round the picked point, in the scene, metres; nothing where nothing was.
std::optional<FittedFeature> sceneFeature(const SceneState& scene, const PickedPoint& point);

/// The point to record for a pick at `world_m` (scene metres) on a layer of the scene, with what was fitted
/// round it (scene, metres).
PickedPoint pickAt(const SceneState& scene, const std::string& layer, const Eigen::Vector3d& world_m,
                   std::optional<double> localSpacing_m = std::nullopt,
                   const std::optional<FittedFeature>& fitted = std::nullopt);

/// The named view in scene metres; a camera bound to a layer (SceneState::viewFrames) moves along with it.
/// Nothing when the view, or the layer it is bound to, is absent.
std::optional<ViewCamera> cameraInScene(const SceneState& scene, const std::string& view);

}  // namespace vestige
