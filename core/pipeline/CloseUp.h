#pragma once

#include <string>
#include <vector>

#include "core/pipeline/ViewRenderer.h"
#include "core/scene/MeasuredScene.h"
#include "core/scene/Scene.h"

namespace vestige {

/// The view without the points further than `radius_m` from `centre` (world), which its picture would not
/// show anyway, and without what hangs higher than `ceiling_m` (world z): tree crowns over a measured object.
/// Meshes stay whole. True when a point was left out for its height.
bool cropView(ViewDescription& view, const SceneState& scene, const Eigen::Vector3d& centre, double radius_m,
              double ceiling_m);

/// A perspective camera that sees the sphere whole, looking along `direction`, z up (y up when looking down).
ViewCamera cameraAround(const Eigen::Vector3d& centre, double radius_m, const Eigen::Vector3d& direction);

/// The direction to look at a measured pair from in `view` (cropped): the first of the recorded aim's own,
/// and of a ring of candidates most nearly square to the pair, from which picking in the measured layers
/// finds both ends unhidden; else one that shows one end.
Eigen::Vector3d closeUpDirection(const ViewDescription& view, const SceneState& scene,
                                 const MeasuredLength& length, const ViewMark& mark);

/// The same for a path through `points` (world) on the named layers: from which most of its points are seen.
/// Paths on the ground are looked at from higher up, where they are less foreshortened.
Eigen::Vector3d closeUpDirection(const ViewDescription& view, const std::vector<std::string>& layers,
                                 const std::vector<Eigen::Vector3d>& points);

/// The sphere that holds a path whole with room round it; world, metres.
struct CloseUpSphere {
    Eigen::Vector3d centre;
    double radius_m = 0;
};
CloseUpSphere sphereRound(const std::vector<Eigen::Vector3d>& points);

}  // namespace vestige
