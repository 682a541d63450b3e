#pragma once

#include <string>
#include <vector>

#include "core/geometry/PoseUncertainty.h"
#include "core/measurement/kinds/KindSpec.h"

namespace vestige {

/// A scan that picks lie on, as a rigid body in the scene.
struct KindBody {
    std::string name;                     ///< as the budget tells it
    std::optional<PoseUncertainty> pose;  ///< scene frame; none: it defines the frame
};

/// One repeat: where it was picked, and the cloud round it where the kind looks at it.
struct KindRepeat {
    std::vector<KindEnd> ends;
    std::vector<Eigen::Vector3d> cloud = {};
    double cloudNoise_m = 0;
    std::vector<Eigen::Vector3d> base = {};  ///< of a kind between two surfaces
    double baseHeight_m = 0;                 ///< standard uncertainty of its height against the cloud's

    KindInput input(std::span<const KindEnd> at, const ParameterSet& settings) const {
        return {at, settings, cloud, cloudNoise_m, base, baseHeight_m};
    }
};

/// Everything the figures of one object by one method are found from.
struct KindMeasurement {
    MeasurementKind kind = MeasurementKind::distance;
    std::map<std::string, double> settings;
    std::vector<KindRepeat> repeats;
    std::vector<KindBody> bodies;
};

struct KindOutcome {
    std::vector<QuantityStatistic> quantities;  ///< the main figure first; empty: not measurable
    std::vector<KindSeries> series;             ///< of the last repeat
    std::vector<std::string> notes;             ///< why a repeat was left out
};

/// Mean, scatter and uncertainty of every figure of the kind. Budget after GUM: repeats s / sqrt(n); sensor
/// noise and point spacing d / sqrt(12) of every pick, independent of each other, or the covariance of a
/// fitted feature; the pose of every scan as one rigid motion of its picks; and the kind's own contributions.
/// Sensitivities are differences over plus and minus one standard uncertainty (GUM 5.1.3, note 2). What is
/// not of the repeats is the root mean square over them.
KindOutcome kindStatistics(const KindMeasurement& measurement);

}  // namespace vestige
