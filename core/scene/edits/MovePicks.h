#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/Scene.h"

namespace vestige {

/// A picked point as it was before its layer moved, and where it stands in the scene.
struct MovedPick {
    std::size_t measurement = 0;
    std::string key;
    std::size_t repeat = 0;
    bool second = false;  ///< the pair's b
    PickedPoint before;
    std::optional<std::size_t> place = std::nullopt;  ///< of a path: which of its points
};

/// Runs `change`, which may move layers but touches no measurement, and rewrites the picks that were made on
/// layers it moved, so that they stay on the same points of the cloud. Picks that a case file gave for a
/// layer not registered yet were made on no known place of the cloud and stay as they are.
std::vector<MovedPick> changeKeepingPicks(SceneState& scene, const std::function<void(SceneState&)>& change);

/// Puts back, bit for bit, what changeKeepingPicks rewrote.
void restorePicks(SceneState& scene, const std::vector<MovedPick>& moved);

}  // namespace vestige
