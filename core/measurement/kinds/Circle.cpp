#include <Eigen/Geometry>
#include <cmath>

#include "core/measurement/kinds/CircleThrough.h"
#include "core/measurement/kinds/KindInput.h"
#include "core/measurement/kinds/PlaneThrough.h"

namespace vestige {

Result<KindValues> circleValues(const KindInput& input) {
    std::vector<Eigen::Vector3d> points;
    double expected = 0;
    for (const KindEnd& end : input.ends) {
        points.push_back(end.position);
        expected += end.standard_m() * end.standard_m() / static_cast<double>(input.size());
    }
    const auto plane = planeThrough(points);
    if (!plane) return fail(plane.error());
    const Eigen::Vector3d across = plane->normal.unitOrthogonal();
    const Eigen::Vector3d up = plane->normal.cross(across);
    std::vector<Eigen::Vector2d> flat;
    for (const auto& point : points)
        flat.emplace_back(across.dot(point - plane->centre), up.dot(point - plane->centre));
    const auto fit = circleThrough(flat);
    if (!fit) return fail(fit.error());

    QuantityValue diameter{"diameter", "Diameter", QuantityUnit::metre, 2 * fit->radius};
    diameter.selfContained = fit->degreesOfFreedom >= 2;
    if (fit->degreesOfFreedom > 0)
        diameter.own.push_back(
            {"departure from a circle", std::sqrt(std::max(0.0, fit->scatter * fit->scatter - expected)), "m",
             2 * fit->radiusPerUnit, Distribution::student, static_cast<double>(fit->degreesOfFreedom), 0});
    const Eigen::Vector3d centre = plane->centre + across * fit->centre.x() + up * fit->centre.y();
    return KindValues{{diameter,
                       {"centre_height", "Height of the centre", QuantityUnit::metre, centre.z()},
                       {"tilt", "Tilt of its plane to the level", QuantityUnit::degree, plane->tilt_deg()}}};
}

}  // namespace vestige
