#pragma once

#include <vector>

#include "core/pipeline/ViewRenderer.h"
#include "core/scene/MeasuredScene.h"
#include "core/scene/Scene.h"

namespace vestige {

/// The view without the points further than `radius_m` from `centre` (world); meshes stay whole. For pictures
/// that would not show them anyway.
void cropView(ViewDescription& view, const SceneState& scene, const Eigen::Vector3d& centre, double radius_m);

/// A perspective camera that sees the sphere whole, looking along `direction`, z up (y up when looking down).
ViewCamera cameraAround(const Eigen::Vector3d& centre, double radius_m, const Eigen::Vector3d& direction);

/// The direction to look at a measured pair from: the first of the recorded aim's own, and of a ring of
/// candidates most nearly square to the pair, from which picking at both ends finds them unhidden.
Eigen::Vector3d closeUpDirection(const SceneState& scene, const MeasuredLength& length, const ViewMark& mark);

}  // namespace vestige
