#include "core/pipeline/KindStrokes.h"

#include <algorithm>
#include <span>

#include "core/measurement/kinds/KindSpec.h"
#include "core/measurement/kinds/PlaneThrough.h"
#include "core/measurement/kinds/SmallestRectangle.h"

namespace vestige {
namespace {

using Points = std::vector<Eigen::Vector3d>;
using Strokes = std::vector<KindStroke>;

Points part(const Points& points, std::size_t from, std::size_t to) {
    return {points.begin() + static_cast<std::ptrdiff_t>(from),
            points.begin() + static_cast<std::ptrdiff_t>(to)};
}

std::size_t count(MeasurementKind kind, const std::map<std::string, double>& settings, const char* key) {
    const auto set = kindSettings(kind, settings);
    return set ? static_cast<std::size_t>(set->integer(key)) : 0;
}

/// From a point square onto the plane through others.
Strokes perpendicular(const Eigen::Vector3d& from, const Points& onPlane) {
    const auto plane = planeThrough(onPlane);
    if (!plane) return {};
    return {{{from, from - plane->signedDistance(from) * plane->normal}}, {onPlane, true}};
}

Strokes betweenPlanes(const Points& first, const Points& second) {
    const auto plane = planeThrough(first);
    if (!plane) return {};
    Strokes strokes = perpendicular(plane->centre, second);
    if (!strokes.empty()) strokes.push_back({first, true});
    return strokes;
}

Strokes edgesOfBox(const Points& picks) {
    std::vector<Eigen::Vector2d> plan;
    double lowest = picks.front().z(), highest = lowest;
    for (const Eigen::Vector3d& pick : picks) {
        plan.emplace_back((pick - picks.front()).head<2>());
        lowest = std::min(lowest, pick.z());
        highest = std::max(highest, pick.z());
    }
    const auto corners = smallestRectangle(plan);
    if (!corners) return {};
    Points below, above;
    for (const Eigen::Vector2d& corner : *corners) {
        const Eigen::Vector2d place = corner + picks.front().head<2>();
        below.emplace_back(place.x(), place.y(), lowest);
        above.emplace_back(place.x(), place.y(), highest);
    }
    Strokes strokes{{above, true}, {below, true}};
    for (std::size_t i = 0; i < corners->size(); ++i) strokes.push_back({{below[i], above[i]}});
    return strokes;
}

Strokes crushStrokes(const Points& picks, std::size_t outline) {
    if (picks.size() < 4 + outline) return {};
    Strokes strokes{{part(picks, 2, picks.size() - outline)}, {part(picks, 0, 2)}};
    if (outline > 1) strokes.push_back({part(picks, picks.size() - outline, picks.size())});
    return strokes;
}

bool isClosed(MeasurementKind kind) {
    return kind == MeasurementKind::area || kind == MeasurementKind::volume ||
           kind == MeasurementKind::circle;
}

Strokes special(MeasurementKind kind, const std::map<std::string, double>& settings, const Points& picks) {
    if (kind == MeasurementKind::pointToPlane && picks.size() >= 4)
        return perpendicular(picks.front(), part(picks, 1, picks.size()));
    if (kind == MeasurementKind::planeToPlane) {
        const std::size_t first = count(kind, settings, "first_plane_points");
        if (first >= 3 && picks.size() >= first + 3)
            return betweenPlanes(part(picks, 0, first), part(picks, first, picks.size()));
    }
    if (kind == MeasurementKind::box && picks.size() >= 3) return edgesOfBox(picks);
    if (kind == MeasurementKind::crush) return crushStrokes(picks, count(kind, settings, "outline_points"));
    return {};
}

}  // namespace

std::vector<KindStroke> strokesOf(MeasurementKind kind, const std::map<std::string, double>& settings,
                                  const std::vector<Eigen::Vector3d>& picks) {
    Strokes strokes = special(kind, settings, picks);
    if (strokes.empty()) strokes.push_back({picks, isClosed(kind)});
    return strokes;
}

}  // namespace vestige
