#pragma once

#include <memory>
#include <string>

namespace vestige {

class PointSet;

/// Points of a layer that are one thing of the scene: a vehicle, a piece of debris.
struct SceneObject {
    std::string name;  ///< unique in the case
    std::string kind;  ///< "vehicle", "debris", "ground", "other"
    std::string layer;
    std::shared_ptr<const PointSet> points;  ///< indices into the layer's points as loaded
    bool visible = true;
};

}  // namespace vestige
