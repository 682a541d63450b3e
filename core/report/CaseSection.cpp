#include "core/base/Numbers.h"
#include "core/report/CaseReport.h"
#include "core/report/Wording.h"

namespace vestige {

Section caseSection(const ReportInput& input) {
    const SceneState& scene = input.scene;
    Facts facts;
    facts.rows.emplace_back("Name", scene.name.empty() ? "not given" : scene.name);
    facts.rows.emplace_back("Operator", scene.operatorName.empty() ? "not given" : scene.operatorName);
    if (scene.site)
        facts.rows.emplace_back("Site (WGS 84)",
                                fixedText(scene.site->latitude_deg, 6) + "\u00b0 latitude, " +
                                    fixedText(scene.site->longitude_deg, 6) + "\u00b0 longitude, " +
                                    fixedText(scene.site->height_m, 1) + " m height");
    if (const Layer* target = scene.layer(scene.target))
        facts.rows.emplace_back("Global cloud", target->name + " (all coordinates are in its frame)");
    std::vector<std::string> names;
    for (const auto& layer : scene.layers)
        if (layer.registration) names.push_back(layer.name);
    facts.rows.emplace_back("Scans fitted to it", names.empty() ? "none" : listed(names));
    Section section{"The case", {std::move(facts)}};
    for (const auto& picture : input.pictures)
        if (picture.kind == ReportPicture::Kind::overview)
            section.blocks.push_back(Picture{picture.png, picture.caption, 1, picture.toScale});
    return section;
}

}  // namespace vestige
