#include <Eigen/Geometry>
#include <cmath>

#include "core/measurement/kinds/Speed.h"

namespace vestige {

Result<KindValues> polylineValues(const KindInput& input) {
    double length = 0, level = 0;
    for (std::size_t i = 1; i < input.size(); ++i) {
        length += (input.at(i) - input.at(i - 1)).norm();
        level += (input.at(i) - input.at(i - 1)).head<2>().norm();
    }
    const Eigen::Vector3d whole = input.at(input.size() - 1) - input.at(0);
    KindValues values{{{"length", "Length along the line", QuantityUnit::metre, length},
                       {"horizontal", "Horizontal length", QuantityUnit::metre, level},
                       {"chord", "Straight from end to end", QuantityUnit::metre, whole.norm()},
                       {"rise", "Height difference of the ends", QuantityUnit::metre, whole.z()}}};
    if (level > 0)
        values.quantities.push_back({"grade", "Mean grade", QuantityUnit::percent, 100 * whole.z() / level});
    const double f = input.settings.real("drag_factor");
    if (f > 0) {
        // v^2 = 2 g f d: all kinetic energy goes into the mark.
        const double speed = 3.6 * std::sqrt(2 * kGravity * f * length);
        values.quantities.push_back({"speed",
                                     "Speed to leave such a skid mark",
                                     QuantityUnit::kilometrePerHour,
                                     speed,
                                     {dragFactorShare(input.settings, speed)}});
    }
    return values;
}

const ParameterTable& polylineParameters() {
    static const ParameterTable table{dragFactorParameter(), dragFactorRangeParameter()};
    return table;
}

}  // namespace vestige
