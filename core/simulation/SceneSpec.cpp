#include "core/simulation/SceneSpec.h"

#include <algorithm>

namespace vestige {

SceneSpec::SceneSpec() : flight(flightParameters()), photogrammetry(photogrammetryParameters()) {}

const ObjectSpec* SceneSpec::object(std::string_view id) const {
    const auto found =
        std::find_if(objects.begin(), objects.end(), [&](const ObjectSpec& one) { return one.id == id; });
    return found == objects.end() ? nullptr : &*found;
}

const ParameterTable& flightParameters() {
    const auto real = [](const char* key, const char* label, const char* unit, double value, double least,
                         double most, const char* help) {
        return ParameterSpec{key, "", label, unit, ParameterType::real, value, least, most, {}, help};
    };
    static const ParameterTable table{
        real("target_x_m", "Target x", "m", 0, -1000, 1000, "Centre of the circle, site frame."),
        real("target_y_m", "Target y", "m", 0, -1000, 1000, "Centre of the circle, site frame."),
        real("radius_m", "Radius", "m", 9, 0, 100, "Of the circle: to the farthest point of the accident."),
        real("height_m", "Height", "m", 15, 2, 120, "Above the target."),
        real("circle_s", "Circle", "s", 40, 0.1, 3600, "Time of one circle."),
        {"pattern",
         "",
         "Pattern",
         "",
         ParameterType::choice,
         std::string("non-repetitive"),
         {},
         {},
         {"non-repetitive", "repetitive"},
         "The scanner's pattern: 70.4 x 77.2 degrees, or lines of 70.4 x 4.5 degrees."}};
    return table;
}

const ParameterTable& photogrammetryParameters() {
    const auto real = [](const char* key, const char* label, const char* unit, double value, double least,
                         double most, const char* help) {
        return ParameterSpec{key, "", label, unit, ParameterType::real, value, least, most, {}, help};
    };
    static const ParameterTable table{
        {"enabled",
         "",
         "Made",
         "",
         ParameterType::boolean,
         true,
         {},
         {},
         {},
         "Whether there is such a cloud."},
        real("reach_m", "Reach", "m", 8, 1, 100, "Half side of the square round the target that is kept."),
        real("spacing_m", "Spacing", "m", 0.02, 0.002, 1,
             "Distance of the points that are kept; a pixel of matching is twice that."),
        real("noise_m", "Noise", "m", 0.045, 0, 1, "Error that neighbours share, one sigma, along the view."),
        real("patch_m", "Patch", "m", 0.12, 0.01, 10, "Length over which neighbours share it."),
        real("fine_noise_m", "Fine noise", "m", 0.010, 0, 1,
             "Error of each point alone, one sigma, along the view."),
        real("scale_sigma", "Scale", "", 0.015, 0, 0.2, "One sigma of the scale's error."),
        real("shift_sigma_m", "Shift", "m", 0.03, 0, 10, "One sigma of the frame's error.")};
    return table;
}

Result<SceneSpec> sceneSpec(const std::string& nameOrFile) {
    if (nameOrFile == "two-cars") return twoCarsScene();
    if (nameOrFile == "bicycle") return bicycleScene();
    if (!std::filesystem::exists(nameOrFile))
        return fail(ErrorCode::input, "there is no such scene", nameOrFile,
                    "two-cars, bicycle, or a JSON file that describes one");
    return readSceneSpec(nameOrFile);
}

}  // namespace vestige
