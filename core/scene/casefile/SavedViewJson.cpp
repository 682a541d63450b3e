#include "core/scene/casefile/SavedViewJson.h"

#include <nlohmann/json.hpp>

#include "core/scene/casefile/CaseJson.h"

namespace vestige {
namespace {

constexpr double kLargestSide_m = 1e7;
constexpr std::int64_t kSmallestScale = 1;
constexpr std::int64_t kLargestScale = 100000;

nlohmann::ordered_json vectorJson(const Eigen::Vector3d& vector) {
    return std::vector<double>(vector.begin(), vector.end());
}

}  // namespace

nlohmann::ordered_json sectionJson(const SectionBox& section) {
    nlohmann::ordered_json json{{"centre", vectorJson(section.centre)},
                                {"half_size_m", vectorJson(section.halfSize)},
                                {"heading_rad", section.heading_rad}};
    if (section.inverted) json["inverted"] = true;
    return json;
}

SectionBox readSection(const JsonCursor& cursor) {
    cursor.warnOfOthers({"centre", "half_size_m", "heading_rad", "inverted"});
    SectionBox section;
    section.centre = cursor.at("centre").vector3();
    section.halfSize = cursor.at("half_size_m").vector3();
    if (!(section.halfSize.minCoeff() > 0) || section.halfSize.maxCoeff() > kLargestSide_m)
        cursor.at("half_size_m")
            .reject("a section box has no such sides", "expected metres above 0, up to 1e7");
    if (const auto heading = cursor.find("heading_rad")) section.heading_rad = heading->real();
    if (const auto inverted = cursor.find("inverted")) section.inverted = inverted->boolean();
    return section;
}

nlohmann::ordered_json savedViewJson(const SavedView& view) {
    nlohmann::ordered_json json{{"name", view.name}, {"camera", viewJson(view.camera, {})}};
    if (view.section) json["section"] = sectionJson(*view.section);
    if (!view.colorMode.empty()) json["color"] = view.colorMode;
    if (view.scale) json["scale"] = *view.scale;
    json["in_report"] = view.inReport;
    return json;
}

SavedView readSavedView(const JsonCursor& cursor) {
    cursor.warnOfOthers({"name", "camera", "section", "color", "scale", "in_report"});
    SavedView view;
    view.name = cursor.at("name").name();
    view.camera = readView(cursor.at("camera"));
    if (const auto section = cursor.find("section")) view.section = readSection(*section);
    if (const auto color = cursor.find("color")) view.colorMode = color->name();
    if (const auto scale = cursor.find("scale")) {
        view.scale = static_cast<int>(scale->integer(kSmallestScale, kLargestScale));
        if (!view.camera.parallel)
            scale->reject("a view in perspective has no scale", "expected a parallel camera, or no scale");
    }
    if (const auto inReport = cursor.find("in_report")) view.inReport = inReport->boolean();
    return view;
}

}  // namespace vestige
