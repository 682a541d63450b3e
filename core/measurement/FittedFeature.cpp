#include "core/measurement/FittedFeature.h"

#include <array>
#include <utility>

namespace vestige {
namespace {

constexpr std::array<std::pair<SnapMode, std::string_view>, 8> kNames{{{SnapMode::point, "point"},
                                                                       {SnapMode::plane, "plane"},
                                                                       {SnapMode::edge, "edge"},
                                                                       {SnapMode::corner, "corner"},
                                                                       {SnapMode::highest, "highest"},
                                                                       {SnapMode::lowest, "lowest"},
                                                                       {SnapMode::circle, "circle"},
                                                                       {SnapMode::centroid, "centroid"}}};

}  // namespace

std::string_view name(SnapMode mode) {
    for (const auto& [each, text] : kNames)
        if (each == mode) return text;
    return "point";
}

std::optional<SnapMode> snapModeFromName(std::string_view name) {
    for (const auto& [each, text] : kNames)
        if (text == name) return each;
    return std::nullopt;
}

}  // namespace vestige
