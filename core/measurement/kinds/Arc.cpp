#include <algorithm>
#include <cmath>

#include "core/measurement/kinds/CircleThrough.h"
#include "core/measurement/kinds/Speed.h"

namespace vestige {
namespace {

/// Chord and middle ordinate of the circle through both ends and the pick that is nearest to the chord's
/// middle. Picked in the very middle, the ordinate is that pick's distance from the chord.
struct Ordinate {
    double chord = 0;
    double middle = 0;
};

Result<Ordinate> ordinateOf(std::span<const Eigen::Vector2d> points) {
    const Eigen::Vector2d start = points.front();
    const Eigen::Vector2d whole = points.back() - start;
    const double chord = whole.norm();
    if (!(chord > 0)) return fail(ErrorCode::input, "the arc ends where it begins");
    const Eigen::Vector2d along = whole / chord;
    double best = chord;
    Eigen::Vector2d nearest = Eigen::Vector2d::Zero();
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const Eigen::Vector2d off = points[i] - start;
        const double x = off.dot(along) - 0.5 * chord;
        if (std::abs(x) >= best) continue;
        best = std::abs(x);
        nearest = {x, std::abs(along.x() * off.y() - along.y() * off.x())};
    }
    if (!(best < 0.5 * chord) || !(nearest.y() > 0))
        return fail(ErrorCode::input, "the points of the arc lie on one line, or none between its ends");
    // Centre (0, k) of the circle through (-+C/2, 0) and (x, y): x^2 + y^2 - C^2/4 = 2 k y.
    const double k = (nearest.squaredNorm() - 0.25 * chord * chord) / (2 * nearest.y());
    const double radius = std::hypot(0.5 * chord, k);
    return Ordinate{chord, radius + k};
}

/// The curve's scatter beyond what sensor and spacing explain, which the picks carry already.
Contribution excessScatter(const KindInput& input, const CircleThrough& fit) {
    double expected = 0;
    for (const KindEnd& end : input.ends)
        expected += end.standard_m() * end.standard_m() / static_cast<double>(input.size());
    const double excess = fit.scatter * fit.scatter - expected;
    return {"departure from a circle", std::sqrt(std::max(0.0, excess)),          "m", fit.radiusPerUnit,
            Distribution::student,     static_cast<double>(fit.degreesOfFreedom), 0};
}

/// v^2 = g R (f + e) / (1 - f e) with the superelevation e; for e = 0 it is 3.86 sqrt(R f) in miles per hour
/// and feet.
QuantityValue speedOf(const KindInput& input, const QuantityValue& radius, const char* key,
                      const char* label) {
    const double f = input.settings.real("drag_factor");
    const double e = input.settings.real("superelevation_percent") / 100;
    const double path = radius.value - input.settings.real("half_track_m");
    const double speed = 3.6 * std::sqrt(std::max(0.0, kGravity * path * (f + e) / (1 - f * e)));
    QuantityValue value{key, label, QuantityUnit::kilometrePerHour, speed};
    value.intervalPower = -2;
    value.selfContained = radius.selfContained;
    if (path > 0)
        for (Contribution own : radius.own) {
            own.sensitivity *= speed / (2 * path);
            value.own.push_back(std::move(own));
        }
    Contribution drag = dragFactorShare(input.settings, speed);
    drag.sensitivity = 0.5 * speed * (1 / (f + e) + e / (1 - f * e));
    value.own.push_back(std::move(drag));
    return value;
}

}  // namespace

Result<KindValues> arcValues(const KindInput& input) {
    std::vector<Eigen::Vector2d> points;
    for (const KindEnd& end : input.ends) points.push_back(end.position.head<2>());
    const auto ordinate = ordinateOf(points);
    if (!ordinate) return fail(ordinate.error());
    const auto fit = circleThrough(points);
    if (!fit) return fail(fit.error());
    const double byChord =
        ordinate->chord * ordinate->chord / (8 * ordinate->middle) + 0.5 * ordinate->middle;

    QuantityValue fitted{"radius_fit", "Radius by fit", QuantityUnit::metre, fit->radius};
    fitted.intervalPower = -1;
    // Two points more than a circle needs: the scatter about it can be told.
    fitted.selfContained = fit->degreesOfFreedom >= 2;
    if (fit->degreesOfFreedom > 0) fitted.own.push_back(excessScatter(input, *fit));
    QuantityValue chorded{"radius_chord", "Radius by chord and middle ordinate", QuantityUnit::metre,
                          byChord};
    chorded.intervalPower = -1;
    const double half = std::min(1.0, 0.5 * ordinate->chord / fit->radius);
    const double arc = 2 * fit->radius * std::asin(half);
    KindValues values{{fitted,
                       chorded,
                       {"chord", "Chord", QuantityUnit::metre, ordinate->chord},
                       {"middle_ordinate", "Middle ordinate", QuantityUnit::metre, ordinate->middle},
                       {"arc_length", "Length of the arc", QuantityUnit::metre, arc}}};
    if (input.settings.real("drag_factor") > 0) {
        values.quantities.push_back(speedOf(input, fitted, "speed_fit", "Critical speed, radius by fit"));
        values.quantities.push_back(
            speedOf(input, chorded, "speed_chord", "Critical speed, radius by chord"));
    }
    return values;
}

const ParameterTable& arcParameters() {
    static const ParameterTable table{
        dragFactorParameter(),
        dragFactorRangeParameter(),
        {"superelevation_percent",
         "",
         "Superelevation",
         "%",
         ParameterType::real,
         0.0,
         -20.0,
         20.0,
         {},
         "Crossfall of the road towards the inside of the bend."},
        {"half_track_m",
         "",
         "Mark to centre of mass",
         "m",
         ParameterType::real,
         0.0,
         0.0,
         3.0,
         {},
         "How far inside of the mark the centre of mass went: half the track width for an outer tyre."}};
    return table;
}

}  // namespace vestige
