#pragma once

#include <string>
#include <vector>

#include "core/measurement/kinds/KindStatistics.h"
#include "core/scene/Scene.h"

namespace vestige {

/// The repeats of one object by one method, without the clouds round them.
struct KindRepeats {
    KindMeasurement measurement;
    std::vector<std::string> layers;  ///< ids, in the order of measurement.bodies
    std::vector<std::string> notes;   ///< what was left out, and why
};

/// Pairs and paths that count for the method, in the target's frame; with `fitted`, features in place of the
/// picks that have one, and nothing when no pick has. Picks on layers that share no frame are left out.
KindRepeats kindRepeats(const SceneState& scene, const Measurement& measurement, const std::string& method,
                        bool fitted);

/// Whether any pick of the object that its kind takes has a fitted feature, and counts for the method.
bool hasFitted(const SceneState& scene, const Measurement& measurement, const std::string& method);

/// The method that repeats under `key` count for: of the layer of that id, else the method of that name, else
/// of the layer of the first point. Empty when the scene has none of them.
std::string methodOfRepeat(const SceneState& scene, const std::string& key, const PickedPoint& first);

/// Sensor noise, spacing and, where there is one, the fitted feature of a pick, as the budget takes them.
KindEnd kindEnd(const SceneState& scene, const PickedPoint& point, bool fitted);

}  // namespace vestige
