#pragma once

#include <Eigen/Core>
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
    bool fitted = false;              ///< between fitted features instead of the points picked
    /// Shorter than three spots of the beam that measured it: what is found is more the beam than the object.
    bool small = false;
    /// Where the repeats begin and end on average, scene, m.
    Eigen::Vector3d a = Eigen::Vector3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
};

struct MeasuredScene {
    std::vector<MeasuredLength> lengths;   ///< by object, then method, in the order of the case
    std::vector<MethodAccuracy> accuracy;  ///< one per method
    std::vector<MeasuredKind> kinds;       ///< every figure, by object, then method
    std::vector<DistanceCheck> checks;     ///< known distances, by object, then method
};

/// METHOD section 5 on the picks of the scene. Methods are those of the scene's layers (and of picks), in
/// layer order; behind a method whose picks have fitted features stands fittedMethod() of it, the same picks
/// by their features. Pure: window, command line and report call it and cannot disagree.
MeasuredScene measureScene(const SceneState& scene);

/// The name of the method that takes what was fitted round the picks of `method`: "lidar fitted".
std::string fittedMethod(const std::string& method);

/// Full width of a sensor's beam at half power, upright and level, rad: METHOD section 1 (aerial 0.28 x 0.03
/// degrees); 0 for the others, whose spot is smaller than their spacing.
struct SensorSpot {
    double upright_rad = 0;
    double level_rad = 0;
};
SensorSpot sensorSpot(LayerRole role);
/// 1 sigma by which a place seen at another time is displaced, from the navigation of a moving sensor: the
/// sheet's 10 mm (aerial), 0 for the others.
double sensorDrift_m(LayerRole role);
/// The longer side of the spot at the working range (15 m): 0.073 m for the aerial scanner.
double sensorBeam_m(LayerRole role);

/// 1 sigma noise of a layer's sensor: METHOD section 1 (aerial 0.03 m, handheld 0.0001 m, photogrammetry 0.05
/// m).
double sensorNoise_m(LayerRole role);
/// Whether neighbouring points err apart from each other, as every fit supposes that averages them. Not in
/// photogrammetry: its depths err together over patches as large as what is fitted, so that a fit would claim
/// to know a place to millimetres that is centimetres off.
bool pointsErrApart(LayerRole role);

}  // namespace vestige
