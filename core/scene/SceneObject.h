#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace vestige {

class PointSet;

/// Points of a layer that are one thing of the scene: a vehicle, a piece of debris.
struct SceneObject {
    std::string name;  ///< unique in the case
    std::string kind;  ///< one of objectKinds()
    std::string layer;
    std::shared_ptr<const PointSet> points;  ///< indices into the layer's points as loaded
    std::uint32_t loadedPoints = 0;          ///< how many the layer had
    std::string sha256;                      ///< of its file, then
    /// Length, width and height of its upright box when it was made, m; not a measurement.
    std::array<double, 3> size_m{};
    std::string found;  ///< how, with the parameters as people read them
    bool visible = true;
};

/// "vehicle", "debris", "vegetation", "ground", "other".
const std::vector<std::string>& objectKinds();

}  // namespace vestige
