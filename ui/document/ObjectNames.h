#pragma once

#include <optional>
#include <string>

#include "core/measurement/kinds/KindSpec.h"
#include "core/scene/Scene.h"

namespace vestige {

/// "Length 1", "Length 2", ...: the first that no object of the case has.
std::string freeObjectName(const SceneState& scene, const std::string& word = {});

/// The first words of a kind's label, in the language of the window: "Arc" of "Arc (yaw mark)".
std::string shortLabel(const KindSpec& spec);

/// Where a repeat stands in Measurement::picks, or in its paths.
struct PickPlace {
    std::string layer;
    std::size_t repeat = 0;
    bool path = false;
};
/// The object's last repeat that counts for `method`.
std::optional<PickPlace> lastPick(const Measurement& measurement, const SceneState& scene,
                                  const std::string& method);

/// How many pairs and paths of the object count for `method`.
std::size_t pickCount(const Measurement& measurement, const SceneState& scene, const std::string& method);

/// Whether a pair under this key is a repeat of `method`: that of its layer, or the one that takes what was
/// fitted round its ends (fittedMethod). Every pair is one of the empty method.
bool countsFor(const SceneState& scene, const std::string& key, const PickedPair& pair,
               const std::string& method);
bool countsFor(const SceneState& scene, const std::string& key, const PickedPath& path,
               const std::string& method);

/// The method that picks under this key (a layer's id, or a method's name) count for.
std::string methodOfKey(const SceneState& scene, const std::string& key);

}  // namespace vestige
