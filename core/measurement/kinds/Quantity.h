#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/measurement/kinds/Budget.h"

namespace vestige {

enum class QuantityUnit { metre, degree, squareMetre, cubicMetre, percent, kilometrePerHour };
/// "m", "deg", "m2", "m3", "%", "km/h": as files have it.
std::string_view symbol(QuantityUnit unit);
/// "m", "°", "m²", "m³", "%", "km/h": as people read it.
std::string_view readableSymbol(QuantityUnit unit);

/// One figure of a measured object as one repeat gives it.
struct QuantityValue {
    std::string key;    ///< "radius_fit"
    std::string label;  ///< "Radius by fit"
    QuantityUnit unit = QuantityUnit::metre;
    double value = 0;
    /// What is uncertain besides where the picks are: scatter about a fitted shape, a drag factor, the
    /// cloud's points.
    std::vector<Contribution> own = {};
    /// The interval is symmetric in value^power: 1 for most, -1 for a radius (symmetric in the curvature), -2
    /// for the speed from one.
    int intervalPower = 1;
    /// Holds its own scatter, so that a single repeat has an uncertainty.
    bool selfContained = false;
};

/// A line to be drawn as a chart: a cross-section, a crush profile; metres.
struct KindSeries {
    std::string name;
    std::vector<std::pair<double, double>> points;

    friend bool operator==(const KindSeries&, const KindSeries&) = default;
};

/// What one repeat of a kind gives; the main figure comes first.
struct KindValues {
    std::vector<QuantityValue> quantities;
    std::vector<KindSeries> series = {};
};

/// A figure of an object over its repeats.
struct QuantityStatistic {
    std::string key;
    std::string label;
    QuantityUnit unit = QuantityUnit::metre;
    std::vector<double> repeats = {};
    double mean = 0;
    std::optional<double> repeatSd = std::nullopt;  ///< none with one repeat
    Budget budget = {};  ///< without the repeats' scatter where there is one repeat
    std::optional<double> standardUncertainty = std::nullopt;
    std::optional<double> degreesOfFreedom = std::nullopt;
    std::optional<double> expandedUncertainty = std::nullopt;  ///< U; none where the scatter is not known
    /// 95 % interval; not symmetric about the mean for radius and speed, without an upper end (infinite)
    /// where a straight line is not ruled out.
    std::optional<double> low = std::nullopt;
    std::optional<double> high = std::nullopt;
    std::optional<double> reference = std::nullopt;  ///< of the tape, or what the case gives for other units
    std::optional<double> referenceUncertainty = std::nullopt;
    std::optional<double> relativeError = std::nullopt;
};

}  // namespace vestige
