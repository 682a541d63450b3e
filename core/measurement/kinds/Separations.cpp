#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/measurement/kinds/KindInput.h"
#include "core/measurement/kinds/PlaneThrough.h"

namespace vestige {
namespace {

using Unit = QuantityUnit;

std::vector<Eigen::Vector3d> positions(std::span<const KindEnd> ends) {
    std::vector<Eigen::Vector3d> points;
    for (const KindEnd& end : ends) points.push_back(end.position);
    return points;
}

/// The plane through picks; where one of them has a fitted plane of its own, that one.
Result<PlaneThrough> planeOf(std::span<const KindEnd> ends) {
    for (const KindEnd& end : ends)
        if (end.normal) return PlaneThrough{end.position, *end.normal, 0};
    return planeThrough(positions(ends));
}

QuantityValue straight(const KindInput& input) {
    return {"distance", "Distance", Unit::metre, (input.at(1) - input.at(0)).norm()};
}
QuantityValue level(const KindInput& input) {
    return {"horizontal", "Horizontal part", Unit::metre, (input.at(1) - input.at(0)).head<2>().norm()};
}
QuantityValue upright(const KindInput& input) {
    return {"vertical", "Vertical part", Unit::metre, std::abs((input.at(1) - input.at(0)).z())};
}

/// The picks of two planes: the first `count` and the others.
Result<std::pair<PlaneThrough, PlaneThrough>> twoPlanes(const KindInput& input) {
    const auto count = static_cast<std::size_t>(input.settings.integer("first_plane_points"));
    if (input.size() < count + 3)
        return fail(ErrorCode::input, "the second plane has fewer than three points");
    const auto first = planeOf(input.ends.first(count));
    if (!first) return fail(first.error());
    const auto second = planeOf(input.ends.subspan(count));
    if (!second) return fail(second.error());
    return std::pair(*first, *second);
}

}  // namespace

Result<KindValues> distanceValues(const KindInput& input) {
    return KindValues{{straight(input), level(input), upright(input)}};
}

Result<KindValues> horizontalValues(const KindInput& input) {
    return KindValues{{level(input), straight(input), upright(input)}};
}

Result<KindValues> verticalValues(const KindInput& input) {
    return KindValues{{upright(input), straight(input), level(input)}};
}

Result<KindValues> pointToPlaneValues(const KindInput& input) {
    const auto plane = planeOf(input.ends.subspan(1));
    if (!plane) return fail(plane.error());
    return KindValues{
        {{"distance", "Distance from the plane", Unit::metre, std::abs(plane->signedDistance(input.at(0)))},
         {"tilt", "Tilt of the plane to the level", Unit::degree, plane->tilt_deg()}}};
}

Result<KindValues> planeToPlaneValues(const KindInput& input) {
    const auto planes = twoPlanes(input);
    if (!planes) return fail(planes.error());
    const auto& [first, second] = *planes;
    // Two planes that are nearly parallel: the mean of the distances of each middle from the other plane.
    const double distance =
        0.5 * (std::abs(first.signedDistance(second.centre)) + std::abs(second.signedDistance(first.centre)));
    const double sine = first.normal.cross(second.normal).norm();
    const double angle = std::atan2(sine, std::abs(first.normal.dot(second.normal)));
    return KindValues{{{"distance", "Distance between the planes", Unit::metre, distance},
                       {"angle", "Angle between the planes", Unit::degree, angle * 180 / std::numbers::pi}}};
}

const ParameterTable& planeToPlaneParameters() {
    static const ParameterTable table{{"first_plane_points",
                                       "",
                                       "Points of the first plane",
                                       "",
                                       ParameterType::integer,
                                       std::int64_t{3},
                                       3.0,
                                       100.0,
                                       {},
                                       "How many picks, from the first on, lie on the first plane; the "
                                       "others lie on the second."}};
    return table;
}

}  // namespace vestige
