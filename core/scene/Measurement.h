#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/measurement/FittedFeature.h"
#include "core/measurement/MeasurementKind.h"

namespace vestige {

/// A picked point as the case file has it: of the target and of layers registered to it in the target's
/// frame, metres; of other layers in the layer's own frame and unit.
struct PickedPoint {
    std::string layer;
    Eigen::Vector3d position;
    std::optional<double> localSpacing_m;  ///< when picked in the window or from an aim
    /// Picked before the layer was registered: `position` is in the layer's own frame and unit whatever
    /// happens to it, and moves along when it is registered (see PickFrame.h).
    bool inLayerFrame = false;
    /// What was fitted round the point, in its frame and unit; `position` stays the measured point.
    std::optional<FittedFeature> fitted = std::nullopt;

    friend bool operator==(const PickedPoint&, const PickedPoint&) = default;
};

/// One repetition of a length.
struct PickedPair {
    PickedPoint a;
    PickedPoint b;

    friend bool operator==(const PickedPair&, const PickedPair&) = default;
};

/// One repetition of what has more ends than two, or one: the corners of a polyline, the stations of a crush
/// profile.
using PickedPath = std::vector<PickedPoint>;

/// A click that was recorded as where it was made instead of what it hit: the pipeline resolves it through
/// pickPoint on the registered scene, exactly as the window would.
struct Aim {
    std::string view;                 ///< key of Scene views
    Eigen::Vector2d pixel;            ///< in that view
    std::vector<std::string> layers;  ///< layers shown while aiming; those the case lacks are ignored
    SnapMode snap = SnapMode::point;  ///< what is fitted to the neighbourhood of the point hit

    friend bool operator==(const Aim&, const Aim&) = default;
};
struct AimedPair {
    Aim a;
    Aim b;

    friend bool operator==(const AimedPair&, const AimedPair&) = default;
};

/// What is measured of one object: what the tape says and what was picked, by layer or method name.
struct Measurement {
    std::string object;
    MeasurementKind kind = MeasurementKind::distance;
    /// Values of the kind's own parameters that differ from their defaults, by key.
    std::map<std::string, double> settings;
    std::optional<double> tape_m;
    std::optional<double> tapeResolution_m;  ///< nothing: 0.01
    /// A known distance at the scene, to check the survey by: how far the measured length may differ from the
    /// tape. Nothing: an object like the others.
    std::optional<double> checkTolerance_m;
    std::map<std::string, std::vector<PickedPair>> picks;  ///< key: layer id, or a method
    std::map<std::string, std::vector<PickedPath>> paths;  ///< of kinds that are not a pair of ends
    std::map<std::string, std::vector<AimedPair>> aims;    ///< key: method

    friend bool operator==(const Measurement&, const Measurement&) = default;
};

}  // namespace vestige
