#pragma once

#include <optional>
#include <string>

#include "core/scene/Scene.h"

namespace vestige {

/// "Length 1", "Length 2", ...: the first that no object of the case has.
std::string freeObjectName(const SceneState& scene);

/// Where a pick stands in Measurement::picks.
struct PickPlace {
    std::string layer;
    std::size_t repeat = 0;
};
/// The object's last pick among the layers of `method` (of all when it is empty).
std::optional<PickPlace> lastPick(const Measurement& measurement, const SceneState& scene,
                                  const std::string& method);

/// How many pairs of the object count for `method`.
std::size_t pickCount(const Measurement& measurement, const SceneState& scene, const std::string& method);

/// The method that picks under this key (a layer's id, or a method's name) count for.
std::string methodOfKey(const SceneState& scene, const std::string& key);

}  // namespace vestige
