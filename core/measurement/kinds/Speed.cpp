#include "core/measurement/kinds/Speed.h"

#include <cmath>

namespace vestige {

ParameterSpec dragFactorParameter() {
    return {"drag_factor",
            "",
            "Drag factor",
            "",
            ParameterType::real,
            0.0,
            0.0,
            2.0,
            {},
            "Friction of tyre and road, in units of gravity, for a speed; 0: no speed is given."};
}

ParameterSpec dragFactorRangeParameter() {
    return {"drag_factor_range",
            "",
            "Drag factor, half range",
            "",
            ParameterType::real,
            0.05,
            0.0,
            1.0,
            {},
            "The drag factor is known to lie within plus and minus this of the value given."};
}

Contribution dragFactorShare(const ParameterSet& settings, double speed_kmh) {
    return {"drag factor",
            settings.real("drag_factor_range") / std::sqrt(3.0),
            "",
            speed_kmh / (2 * settings.real("drag_factor")),
            Distribution::rectangular,
            std::numeric_limits<double>::infinity(),
            0};
}

}  // namespace vestige
