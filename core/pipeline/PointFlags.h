#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/scene/Scene.h"

namespace vestige {

/// Per point of a layer, not 0 for those of some set; null for none of them.
using PointFlags = std::shared_ptr<const std::vector<std::uint8_t>>;

/// `sets` of indices into the points as loaded, as flags of the points that the layer has now.
PointFlags pointFlags(const LayerData& data, std::span<const PointSet* const> sets);

/// What of a layer is not shown although the layer is: objects that are hidden, and what cleaning has taken
/// out already while the layer's data still have it.
std::vector<std::shared_ptr<const PointSet>> hiddenSets(const SceneState& scene, const Layer& layer);

}  // namespace vestige
