#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vestige {

/// A picked point as the case file has it: of the target and of layers registered to it in the target's
/// frame, metres; of other layers in the layer's own frame and unit.
struct PickedPoint {
    std::string layer;
    Eigen::Vector3d position;
    std::optional<double> localSpacing_m;  ///< when picked in the window or from an aim
};

/// One repetition of a length.
struct PickedPair {
    PickedPoint a;
    PickedPoint b;
};

/// A click that was recorded as where it was made instead of what it hit: the pipeline resolves it through
/// pickPoint on the registered scene, exactly as the window would.
struct Aim {
    std::string view;                 ///< key of Scene views
    Eigen::Vector2d pixel;            ///< in that view
    std::vector<std::string> layers;  ///< layers shown while aiming; those the case lacks are ignored
};
struct AimedPair {
    Aim a;
    Aim b;
};

/// A length of one object: what the tape says and what was picked, by layer or method name.
struct Measurement {
    std::string object;
    std::optional<double> tape_m;
    std::optional<double> tapeResolution_m;                ///< nothing: 0.01
    std::map<std::string, std::vector<PickedPair>> picks;  ///< key: layer id as in the case file
    std::map<std::string, std::vector<AimedPair>> aims;    ///< key: method
};

}  // namespace vestige
