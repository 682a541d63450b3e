#include <Eigen/Geometry>
#include <cmath>

#include "core/measurement/kinds/KindInput.h"
#include "core/measurement/kinds/Reference.h"

namespace vestige {

Result<KindValues> areaValues(const KindInput& input) {
    // Half the sum of the cross products of the corners, from the first one: exact far from the origin, too.
    Eigen::Vector3d twice = Eigen::Vector3d::Zero();
    double round = 0;
    for (std::size_t i = 0; i < input.size(); ++i) {
        const Eigen::Vector3d here = input.at(i) - input.at(0);
        const Eigen::Vector3d next = input.at((i + 1) % input.size()) - input.at(0);
        twice += here.cross(next);
        round += (next - here).norm();
    }
    return KindValues{{{"area", "Area", QuantityUnit::squareMetre, 0.5 * twice.norm()},
                       {"area_plan", "Area in plan", QuantityUnit::squareMetre, 0.5 * std::abs(twice.z())},
                       {"perimeter", "Perimeter", QuantityUnit::metre, round}}};
}

const ParameterTable& areaParameters() {
    static const ParameterTable table{referenceParameter("reference_m2", "m2")};
    return table;
}

}  // namespace vestige
