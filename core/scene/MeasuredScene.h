#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/measurement/Accuracy.h"
#include "core/measurement/Length.h"
#include "core/scene/MeasuredKinds.h"
#include "core/scene/Scene.h"

namespace vestige {

/// One object measured by one method: a row of measurements.csv and of the window's table.
struct MeasuredLength {
    std::string object;
    std::string method;
    std::optional<double> tape_m;
    double tapeUncertainty_m = 0;
    std::optional<LengthStatistic> length;  ///< none: not measurable with this method
    std::optional<double> re;
    bool excluded = false;
    std::vector<std::string> layers;  ///< ids the picks lie on
    std::string note;                 ///< why it is not measurable, or what to know
};

struct MeasuredScene {
    std::vector<MeasuredLength> lengths;   ///< by object, then method, in the order of the case
    std::vector<MethodAccuracy> accuracy;  ///< one per method
    std::vector<MeasuredKind> kinds;       ///< every figure, by object, then method
    std::vector<DistanceCheck> checks;     ///< known distances, by object, then method
};

/// METHOD section 5 on the picks of the scene. Methods are those of the scene's layers (and of picks), in
/// layer order. Pure: window, command line and report call it and cannot disagree.
MeasuredScene measureScene(const SceneState& scene);

/// 1 sigma noise of a layer's sensor: METHOD section 1 (aerial 0.03 m, handheld 0.0001 m, photogrammetry 0.05
/// m).
double sensorNoise_m(LayerRole role);

}  // namespace vestige
