#include "core/measurement/MeasurementKind.h"

#include <array>
#include <utility>

namespace vestige {
namespace {

using Kind = MeasurementKind;
constexpr std::array<std::pair<Kind, std::string_view>, 14> kNames{{{Kind::distance, "distance"},
                                                                    {Kind::horizontal, "horizontal"},
                                                                    {Kind::vertical, "vertical"},
                                                                    {Kind::pointToPlane, "point-to-plane"},
                                                                    {Kind::planeToPlane, "plane-to-plane"},
                                                                    {Kind::angle, "angle"},
                                                                    {Kind::polyline, "polyline"},
                                                                    {Kind::arc, "arc"},
                                                                    {Kind::area, "area"},
                                                                    {Kind::circle, "circle"},
                                                                    {Kind::box, "box"},
                                                                    {Kind::profile, "profile"},
                                                                    {Kind::crush, "crush"},
                                                                    {Kind::volume, "volume"}}};

}  // namespace

std::string_view name(MeasurementKind kind) {
    for (const auto& [each, text] : kNames)
        if (each == kind) return text;
    return "distance";
}

std::optional<MeasurementKind> measurementKindFromName(std::string_view name) {
    for (const auto& [each, text] : kNames)
        if (text == name) return each;
    return std::nullopt;
}

}  // namespace vestige
