#include "core/measurement/kinds/KindSpec.h"

#include <algorithm>
#include <cmath>

namespace vestige {
namespace {

using Kind = MeasurementKind;

const ParameterTable& none() {
    static const ParameterTable table;
    return table;
}

std::vector<KindSpec> makeTable() {
    return {
        {Kind::distance,
         "Distance",
         "The straight distance between two points.",
         2,
         2,
         {"an end"},
         true,
         false,
         false,
         &none(),
         distanceValues},
        {Kind::horizontal,
         "Horizontal distance",
         "The level part of the way between two points.",
         2,
         2,
         {"an end"},
         true,
         true,
         false,
         &none(),
         horizontalValues},
        {Kind::vertical,
         "Height difference",
         "The upright part of the way between two points.",
         2,
         2,
         {"an end"},
         true,
         true,
         false,
         &none(),
         verticalValues},
        {Kind::pointToPlane,
         "Point to plane",
         "The distance of the first point from the plane through the others.",
         4,
         0,
         {"the point", "a point of the plane"},
         true,
         false,
         false,
         &none(),
         pointToPlaneValues},
        {Kind::planeToPlane,
         "Plane to plane",
         "The distance between two planes and the angle between them.",
         6,
         0,
         {"a point of the first plane", "a point of the first plane", "a point of the first plane",
          "a point of the second plane"},
         true,
         false,
         false,
         &planeToPlaneParameters(),
         planeToPlaneValues},
        {Kind::angle,
         "Angle",
         "The angle at the second of three points.",
         3,
         3,
         {"an end of the first leg", "the vertex", "an end of the second leg"},
         false,
         false,
         false,
         &angleParameters(),
         angleValues},
        {Kind::polyline,
         "Polyline (skid mark)",
         "The length along a line through several points.",
         2,
         0,
         {"the start", "the next point"},
         true,
         false,
         false,
         &polylineParameters(),
         polylineValues},
        {Kind::arc,
         "Arc (yaw mark)",
         "The radius of a mark in plan: by chord and middle ordinate, and by a circle fitted to all points.",
         3,
         0,
         {"the start of the arc", "the next point of the arc"},
         true,
         true,
         false,
         &arcParameters(),
         arcValues},
        {Kind::area,
         "Area",
         "The area within a closed outline.",
         3,
         0,
         {"a corner of the outline", "the next corner of the outline"},
         false,
         false,
         false,
         &areaParameters(),
         areaValues},
        {Kind::circle,
         "Circle",
         "The diameter of a circle fitted to points of its rim.",
         3,
         0,
         {"a point of the rim"},
         true,
         false,
         false,
         &none(),
         circleValues},
        {Kind::box,
         "Box",
         "Length, width and height of the smallest upright box round the points.",
         4,
         0,
         {"a point that the box is to reach"},
         true,
         true,
         false,
         &none(),
         boxValues},
        {Kind::profile,
         "Cross-section",
         "The heights of the cloud along a line in plan, and their dimensions.",
         2,
         2,
         {"the start of the section", "the end of the section"},
         true,
         true,
         true,
         &profileParameters(),
         profileValues},
        {Kind::crush,
         "Crush profile",
         "Depths C1 to C6 at evenly spaced stations of the damage, from the undamaged outline.",
         4,
         0,
         {"the first undamaged end", "the second undamaged end", "the start of the damage",
          "the next point of the damaged surface"},
         true,
         true,
         false,
         &crushParameters(),
         crushValues},
        {Kind::volume,
         "Volume",
         "The space between the cloud and a base plane within an outline.",
         3,
         0,
         {"a corner of the outline", "the next corner of the outline"},
         false,
         true,
         true,
         &volumeParameters(),
         volumeValues},
    };
}

}  // namespace

const std::string& KindSpec::pickName(std::size_t place) const {
    return picks[std::min(place, picks.size() - 1)];
}

const std::string& pickName(const KindSpec& spec, const std::map<std::string, double>& settings,
                            std::size_t place) {
    const auto first = settings.find("first_plane_points");
    if (first == settings.end()) return spec.pickName(place);
    return static_cast<double>(place) < first->second ? spec.picks.front() : spec.picks.back();
}

std::string pickAdvice(const KindSpec& spec, const std::map<std::string, double>& settings) {
    if (spec.kind != Kind::crush) return {};
    const auto outline = settings.find("outline_points");
    if (outline == settings.end() || outline->second == 0)
        return "Depths count from the straight line between the undamaged ends. For a bulged side trace the "
               "whole "
               "outline last, and set in the panel how many points it has.";
    return "The last " + std::to_string(static_cast<int>(outline->second)) +
           " points trace the undamaged outline, from its first end to the second, here or on a scan of "
           "another "
           "vehicle.";
}

const std::vector<KindSpec>& kindTable() {
    static const std::vector<KindSpec> table = makeTable();
    return table;
}

const KindSpec& kindSpec(MeasurementKind kind) {
    const auto& table = kindTable();
    return *std::find_if(table.begin(), table.end(),
                         [kind](const KindSpec& spec) { return spec.kind == kind; });
}

Result<ParameterSet> kindSettings(MeasurementKind kind, const std::map<std::string, double>& values) {
    ParameterSet settings(*kindSpec(kind).parameters);
    for (const auto& [key, value] : values) {
        const ParameterSpec* spec = settings.find(key);
        ParameterValue wanted = value;
        if (spec && spec->type == ParameterType::integer && value == std::round(value) &&
            std::abs(value) < 1e9)
            wanted = static_cast<std::int64_t>(value);
        if (spec && spec->type == ParameterType::boolean && (value == 0 || value == 1)) wanted = value == 1;
        if (const Status set = settings.set(key, std::move(wanted)); !set)
            return fail(ErrorCode::input, set.error().message, set.error().place, set.error().hint);
    }
    return settings;
}

}  // namespace vestige
