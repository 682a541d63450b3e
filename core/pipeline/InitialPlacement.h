#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/registration/global/FirstPose.h"
#include "core/scene/Scene.h"

namespace vestige {

/// Where a layer's registration starts.
struct InitialPlacement {
    Similarity targetFromSource;
    /// How far off it may be, metres; nothing when nothing is known (identity).
    std::optional<double> reach_m;
    std::optional<double> error_m;   ///< residual of picked pairs, root mean square
    std::vector<std::string> notes;  ///< unit recognised, residual of each picked pair
    std::optional<FirstPose> found;  ///< what the search for an automatic first pose found
};

/// From the layer's InitialPoseSpec and unit, both layers loaded; "auto" searches the whole target.
/// ErrorCode::input for picks that cannot be read, ErrorCode::untrustworthy for picks that determine no pose
/// and for a search that finds none.
Result<InitialPlacement> initialPlacement(const SceneState& scene, const Layer& layer, const Layer& target,
                                          const JobControl& control = {});

}  // namespace vestige
