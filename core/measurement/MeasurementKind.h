#pragma once

#include <optional>
#include <string_view>

namespace vestige {

/// What of an object is measured.
enum class MeasurementKind {
    distance,
    horizontal,
    vertical,
    pointToPlane,
    planeToPlane,
    angle,
    polyline,
    arc,
    area,
    circle,
    box,
    profile,
    crush,
    volume
};
/// As the case file has it: "point-to-plane".
std::string_view name(MeasurementKind kind);
std::optional<MeasurementKind> measurementKindFromName(std::string_view name);

}  // namespace vestige
