#include "core/scene/Layer.h"

namespace vestige {

std::string_view name(LayerRole role) {
    switch (role) {
        case LayerRole::aerial:
            return "aerial";
        case LayerRole::handheld:
            return "handheld";
        case LayerRole::photogrammetry:
            return "photogrammetry";
    }
    return "";
}

std::optional<LayerRole> layerRoleFromName(std::string_view text) {
    for (const auto role : {LayerRole::aerial, LayerRole::handheld, LayerRole::photogrammetry})
        if (name(role) == text) return role;
    return std::nullopt;
}

std::string_view defaultMethod(LayerRole role) {
    return role == LayerRole::photogrammetry ? "photogrammetry" : "lidar";
}

std::array<std::uint8_t, 3> defaultTint(std::size_t place) {
    // A calm grey-blue for the first cloud, which is everywhere, then Okabe and Ito (2008) without black.
    static constexpr std::array<std::array<std::uint8_t, 3>, 8> kPalette{{{160, 180, 200},
                                                                          {230, 159, 0},
                                                                          {0, 158, 115},
                                                                          {204, 121, 167},
                                                                          {240, 228, 66},
                                                                          {0, 114, 178},
                                                                          {213, 94, 0},
                                                                          {86, 180, 233}}};
    return kPalette[place % kPalette.size()];
}

std::string referenceOf(const InitialPoseSpec& init) {
    if (const auto* picks = std::get_if<InitPicks>(&init)) return picks->to;
    if (const auto* pose = std::get_if<InitPose>(&init)) return pose->to;
    return {};
}

std::optional<LengthUnit> Layer::fileUnit() const {
    if (!data || !data->info.metresPerUnit) return std::nullopt;
    return lengthUnitOf(*data->info.metresPerUnit);
}

double Layer::metresPerUnit() const {
    if (unit) return metresPer(*unit);
    return data && data->info.metresPerUnit ? *data->info.metresPerUnit : 1;
}

LengthUnit Layer::lengthUnit() const {
    return unit ? *unit : nearestLengthUnit(metresPerUnit());
}

Similarity sceneFromLayer(const Layer& layer) {
    if (layer.registration) return layer.registration->targetFromSource;
    return {Pose::Identity(), layer.metresPerUnit()};
}

}  // namespace vestige
