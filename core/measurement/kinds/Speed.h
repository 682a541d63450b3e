#pragma once

#include "core/measurement/kinds/KindInput.h"

namespace vestige {

/// Standard gravity, m/s^2.
constexpr double kGravity = 9.80665;

/// The parameters of a drag factor f: "drag_factor" (0: none given) and half the width of its range.
ParameterSpec dragFactorParameter();
ParameterSpec dragFactorRangeParameter();

/// The share of the drag factor's range in a speed that goes with its square root: v / (2 f), rectangular.
Contribution dragFactorShare(const ParameterSet& settings, double speed_kmh);

}  // namespace vestige
