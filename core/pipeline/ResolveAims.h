#pragma once

#include <vector>

#include "core/base/JobControl.h"
#include "core/scene/Scene.h"

namespace vestige {

/// The scene's measurements with every aim turned into picks by pickPoint on the registered, loaded layers;
/// the picks stand under the aim's method and replace what stood there. An aim that hits nothing, or whose
/// view or layers the case lacks, gives no pick. Cancelled: the measurements as they were.
std::vector<Measurement> resolveAims(const SceneState& scene, const JobControl& control);

}  // namespace vestige
