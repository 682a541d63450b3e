#include "core/simulation/shapes/CarShape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace vestige {
namespace {

struct Knot {
    double at;
    double value;
};

/// Cosine interpolation between knots: smooth, never beyond the knots, exactly flat between equal ones.
double along(std::span<const Knot> knots, double at) {
    if (at <= knots.front().at) return knots.front().value;
    for (std::size_t i = 1; i < knots.size(); ++i) {
        if (at > knots[i].at) continue;
        const double share = (at - knots[i - 1].at) / (knots[i].at - knots[i - 1].at);
        const double smooth = share * share * (3 - 2 * share);
        return knots[i - 1].value + smooth * (knots[i].value - knots[i - 1].value);
    }
    return knots.back().value;
}

constexpr std::array<Knot, 9> kDeck{{{-1, 0.88},
                                     {-0.96, 1.02},
                                     {-0.80, 1.06},
                                     {-0.62, 1.02},
                                     {0.05, 0.93},
                                     {0.42, 0.94},
                                     {0.80, 0.84},
                                     {0.95, 0.76},
                                     {1, 0.68}}};
constexpr std::array<Knot, 6> kWidth{
    {{0.18, 0.93}, {0.35, 0.985}, {0.55, 1.0}, {0.78, 1.0}, {0.92, 0.975}, {1.08, 0.945}}};
constexpr std::array<Knot, 6> kRecess{
    {{0.18, 0.08}, {0.34, 0.015}, {0.42, 0}, {0.58, 0}, {0.72, 0.06}, {1.05, 0.12}}};

}  // namespace

CarShape::CarShape(const ParameterSet& parameters)
    : halfLength(0.5 * parameters.real("length_m")),
      halfWidth(0.5 * parameters.real("width_m")),
      height(parameters.real("height_m")),
      wheelRadius(0.5 * parameters.real("wheel_diameter_m")),
      archRadius(wheelRadius + 0.045),
      axle(0.565 * halfLength),
      mirrorWidth(parameters.real("mirror_width_m")),
      handleLength(parameters.real("handle_length_m")),
      paint(*materialFromName(parameters.text("paint"))),
      cowl(0.42 * halfLength),
      roofFront(0.10 * halfLength),
      roofRear(-0.44 * halfLength),
      rearBase(-0.74 * halfLength),
      mirrorX(0.29 * halfLength),
      handleX(-0.06 * halfLength),
      mirrorZ(1.03),
      handleZ(0.83),
      mirrorInner(halfWidth + 0.03) {}

double CarShape::deckHeight(double x) const {
    return along(kDeck, x / halfLength);
}

double CarShape::lowerEdge(double x) const {
    const double fromAxle = std::abs(std::abs(x) - axle);
    if (fromAxle < archRadius) return wheelRadius + std::sqrt(archRadius * archRadius - fromAxle * fromAxle);
    return 0.20 + 0.05 * std::max(0.0, (std::abs(x) / halfLength - 0.85) / 0.15);
}

double CarShape::widthShare(double z) const {
    return along(kWidth, z);
}

double CarShape::endRecess(double z) const {
    return along(kRecess, z);
}

double CarShape::planWidth(double u) {
    const double beyond = (std::abs(u) - kStraightTo) / (1 - kStraightTo);
    return beyond <= 0 ? 1 : std::cbrt(1 - std::min(1.0, beyond * beyond * beyond));
}

double CarShape::planLength(double v) {
    return kStraightTo + (1 - kStraightTo) * std::cbrt(1 - std::abs(v * v * v));
}

double CarShape::railHeight(double s) const {
    const double fromTop = s - 0.4;
    return height - 0.06 - 0.18 * fromTop * fromTop;
}

}  // namespace vestige
