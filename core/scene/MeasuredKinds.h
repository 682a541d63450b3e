#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/measurement/MeasurementKind.h"
#include "core/measurement/kinds/Quantity.h"

namespace vestige {

struct SceneState;
struct Measurement;
struct MeasuredLength;
struct MeasuredScene;

/// Every figure of one object by one method, with its budget.
struct MeasuredKind {
    std::string object;
    std::string method;
    MeasurementKind kind = MeasurementKind::distance;
    std::vector<QuantityStatistic> quantities;  ///< the main one first; empty: not measurable
    std::vector<KindSeries> series;             ///< of its last repeat, for a chart
    std::string parameters;                     ///< "drag_factor=0.7 drag_factor_range=0.05"
    std::vector<std::string> layers;            ///< ids the picks lie on
    std::string note;                           ///< why it is not measurable, or what to know

    const QuantityStatistic* find(const std::string& key) const;
};

/// A known distance at the scene held against what was measured.
struct DistanceCheck {
    enum class Verdict { passed, failed, notMeasured };

    std::string object;
    std::string method;
    double reference_m = 0;
    double tolerance_m = 0;
    std::optional<double> measured_m = std::nullopt;
    std::optional<double> expandedUncertainty_m = std::nullopt;
    std::optional<double> difference_m = std::nullopt;  ///< measured - reference
    Verdict verdict = Verdict::notMeasured;
    std::string note = {};  ///< what weakens it
};
std::string_view name(DistanceCheck::Verdict verdict);

/// Whether "verified" may be said of what a method measured.
enum class Verification { notChecked, failed, verified };
/// "not verified", "failed", "verified".
std::string_view name(Verification verification);

/// Verified: at least one known distance was measured by the method within its tolerance, and none beyond.
Verification verification(const std::vector<DistanceCheck>& checks, const std::string& method);
/// Of the scene as a whole: every method that measured a length is verified; failed where one is.
Verification verification(const MeasuredScene& measured);

/// The figures of every object by each of the methods that it was picked with; with fitted features in the
/// place of the picks under "METHOD fitted".
std::vector<MeasuredKind> measureKinds(const SceneState& scene, const std::vector<std::string>& methods);

/// The row of measurements.csv of an object whose kind is a length other than a distance; nothing for kinds
/// that are none.
std::optional<MeasuredLength> lengthOfKind(const std::vector<MeasuredKind>& kinds,
                                           const Measurement& measurement, const std::string& method);

/// The known distances among the lengths.
std::vector<DistanceCheck> distanceChecks(const SceneState& scene,
                                          const std::vector<MeasuredLength>& lengths);

}  // namespace vestige
