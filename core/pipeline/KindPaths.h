#pragma once

#include <string>
#include <vector>

#include "core/pipeline/ViewRenderer.h"
#include "core/scene/MeasuredScene.h"
#include "core/scene/Scene.h"

namespace vestige {

/// What objects whose kind is picked as a path look like in a view, in scene metres: the line through the
/// points of the last repeat (closed for an area or a volume), labelled with the
/// main figure. Of one method, or of all where it is empty; the object named `selected` is highlighted.
std::vector<ViewPath> measurementPaths(const SceneState& scene, const MeasuredScene& measured,
                                       const std::string& method = {}, const std::string& selected = {});

}  // namespace vestige
