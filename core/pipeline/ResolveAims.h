#pragma once

#include <vector>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/scene/Scene.h"

namespace vestige {

/// Turns every aim of the scene into picks with pickPoint on the registered, loaded layers; an aim that hits
/// nothing, or whose layers the case lacks, gives no pick. Replaces picks that earlier aims gave.
std::vector<Measurement> resolveAims(const SceneState& scene, const JobControl& control);

}  // namespace vestige
