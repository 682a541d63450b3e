#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/base/ParameterSet.h"
#include "core/base/Result.h"
#include "core/measurement/kinds/Quantity.h"

namespace vestige {

/// One picked point of a kind, scene frame (z up), metres.
struct KindEnd {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    double noise_m = 0;    ///< 1 sigma of the sensor
    double spacing_m = 0;  ///< of the cloud round it
    /// Of a fitted feature: covariance of `position`, in place of noise and spacing; m^2.
    std::optional<Eigen::Matrix3d> covariance = std::nullopt;
    /// Of a fitted plane: its unit normal.
    std::optional<Eigen::Vector3d> normal = std::nullopt;
    std::size_t body = 0;  ///< which scan it lies on, as KindMeasurement::bodies numbers them

    /// Standard uncertainty along one axis.
    double standard_m() const;
};

/// What a kind is found from: the picks of one repeat, and the cloud round them where the kind looks at it.
struct KindInput {
    std::span<const KindEnd> ends;
    const ParameterSet& settings;
    std::span<const Eigen::Vector3d> cloud = {};
    double cloudNoise_m = 0;  ///< 1 sigma of its points
    /// Another surface that heights are counted from, and the standard uncertainty of its height.
    std::span<const Eigen::Vector3d> base = {};
    double baseHeight_m = 0;

    const Eigen::Vector3d& at(std::size_t i) const { return ends[i].position; }
    std::size_t size() const { return ends.size(); }
};

/// Every kind is such a function: pure, of any order of magnitude. ErrorCode::input with a sentence where the
/// picks do not determine it.
using EvaluateKind = Result<KindValues> (*)(const KindInput&);

Result<KindValues> distanceValues(const KindInput& input);
Result<KindValues> horizontalValues(const KindInput& input);
Result<KindValues> verticalValues(const KindInput& input);
Result<KindValues> pointToPlaneValues(const KindInput& input);
Result<KindValues> planeToPlaneValues(const KindInput& input);
Result<KindValues> angleValues(const KindInput& input);
Result<KindValues> polylineValues(const KindInput& input);
Result<KindValues> arcValues(const KindInput& input);
Result<KindValues> areaValues(const KindInput& input);
Result<KindValues> circleValues(const KindInput& input);
Result<KindValues> boxValues(const KindInput& input);
Result<KindValues> profileValues(const KindInput& input);
Result<KindValues> crushValues(const KindInput& input);
Result<KindValues> volumeValues(const KindInput& input);

/// The parameters of those that have some.
const ParameterTable& planeToPlaneParameters();
const ParameterTable& angleParameters();
const ParameterTable& polylineParameters();
const ParameterTable& arcParameters();
const ParameterTable& areaParameters();
const ParameterTable& profileParameters();
const ParameterTable& crushParameters();
const ParameterTable& volumeParameters();

}  // namespace vestige
