#pragma once

#include <vector>

#include "core/report/Section.h"
#include "core/scene/JointAdjustment.h"
#include "core/scene/Scene.h"

namespace vestige {

/// The part of the registration section that tells how several layers were adjusted together: the pairs, the
/// loops with their closures, and what it did to each layer.
std::vector<Block> adjustmentBlocks(const JointAdjustment& adjustment, const SceneState& scene);

}  // namespace vestige
