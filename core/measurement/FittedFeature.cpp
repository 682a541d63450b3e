#include "core/measurement/FittedFeature.h"

#include <array>
#include <utility>

namespace vestige {
namespace {

constexpr std::array<std::pair<SnapMode, std::string_view>, 9> kNames{{{SnapMode::point, "point"},
                                                                       {SnapMode::plane, "plane"},
                                                                       {SnapMode::edge, "edge"},
                                                                       {SnapMode::corner, "corner"},
                                                                       {SnapMode::highest, "highest"},
                                                                       {SnapMode::lowest, "lowest"},
                                                                       {SnapMode::circle, "circle"},
                                                                       {SnapMode::centroid, "centroid"},
                                                                       {SnapMode::surface, "surface"}}};

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

FittedFeature moved(const FittedFeature& feature, const Similarity& toFromHere) {
    const Eigen::Matrix3d turn = toFromHere.pose.linear();
    const double scale = toFromHere.scale;
    FittedFeature there = feature;
    there.position = toFromHere * feature.position;
    there.axis = turn * feature.axis;
    there.covariance = scale * scale * turn * feature.covariance * turn.transpose();
    there.radius *= scale;
    there.radiusUncertainty *= scale;
    there.rms *= scale;
    return there;
}

}  // namespace vestige
