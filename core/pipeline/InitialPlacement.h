#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/scene/Scene.h"

namespace vestige {

/// Where a layer's registration starts.
struct InitialPlacement {
    Similarity targetFromSource;
    /// How far off it may be, metres; nothing when nothing is known (identity).
    std::optional<double> reach_m;
    std::optional<double> error_m;   ///< residual of picked pairs, root mean square
    std::vector<std::string> notes;  ///< unit recognised, residual of each picked pair
};

/// From the layer's InitialPoseSpec and unit, both layers loaded. ErrorCode::input for "auto" and for picks
/// that cannot be read, ErrorCode::untrustworthy for picks that determine no pose.
Result<InitialPlacement> initialPlacement(const SceneState& scene, const Layer& layer, const Layer& target);

}  // namespace vestige
