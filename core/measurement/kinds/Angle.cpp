#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/measurement/kinds/KindInput.h"
#include "core/measurement/kinds/Reference.h"

namespace vestige {

Result<KindValues> angleValues(const KindInput& input) {
    const Eigen::Vector3d first = input.at(0) - input.at(1);
    const Eigen::Vector3d second = input.at(2) - input.at(1);
    if (!(first.norm() > 0) || !(second.norm() > 0))
        return fail(ErrorCode::input, "a leg of the angle has no length");
    const auto degrees = [](double sine, double cosine) {
        return std::atan2(sine, cosine) * 180 / std::numbers::pi;
    };
    const Eigen::Vector2d a = first.head<2>(), b = second.head<2>();
    KindValues values{
        {{"angle", "Angle", QuantityUnit::degree, degrees(first.cross(second).norm(), first.dot(second))}}};
    if (a.norm() > 1e-9 * first.norm() && b.norm() > 1e-9 * second.norm())
        values.quantities.push_back({"angle_plan", "Angle in plan", QuantityUnit::degree,
                                     degrees(std::abs(a.x() * b.y() - a.y() * b.x()), a.dot(b))});
    return values;
}

const ParameterTable& angleParameters() {
    static const ParameterTable table{referenceParameter("reference_deg", "deg")};
    return table;
}

}  // namespace vestige
