#pragma once

#include <optional>

#include "core/pipeline/ViewRenderer.h"
#include "core/scene/MeasuredScene.h"
#include "core/scene/Scene.h"

namespace vestige {

/// One measured length as the view draws it, between the means of its repeats' ends, in scene metres, with
/// its length and expanded uncertainty. Nothing when it was not measured or its picks are gone.
std::optional<ViewMark> measurementMark(const SceneState& scene, const MeasuredLength& length);

}  // namespace vestige
