#pragma once

#include <string>
#include <vector>

#include "core/pipeline/ViewRenderer.h"
#include "core/scene/MeasuredScene.h"
#include "core/scene/Scene.h"

namespace vestige {

/// What objects whose kind is picked as a path look like in a view, in scene metres: the strokes of the last
/// repeat (KindStrokes.h), the first of each object labelled with the main figure where there is one. Of one
/// method, or of all where it is empty; the object named `selected` is highlighted.
std::vector<ViewPath> measurementPaths(const SceneState& scene, const MeasuredScene& measured,
                                       const std::string& method = {}, const std::string& selected = {});

}  // namespace vestige
