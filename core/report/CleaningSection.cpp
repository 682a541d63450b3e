#include <algorithm>

#include "core/base/Numbers.h"
#include "core/report/CaseReport.h"
#include "core/report/Wording.h"
#include "core/scene/Cleaning.h"

namespace vestige {
namespace {

Table stepsTable(const SceneState& scene) {
    Table table;
    table.caption = "What was taken out of the clouds";
    table.columns = {"Layer", "Step", "Points", "Parameters"};
    table.numeric = {false, false, true, false};
    table.widths = {20, 18, 14, 60};
    for (const Layer& layer : scene.layers) {
        if (!layer.cleaning) continue;
        for (const CleaningStep& step : layer.cleaning->steps)
            table.rows.push_back({layer.name, step.how, grouped(step.points), step.parameters});
        const std::size_t removed = layer.cleaning->removed.size();
        table.emphasised.push_back(table.rows.size());
        table.rows.push_back({layer.name, "in all", grouped(removed),
                              "of " + grouped(layer.cleaning->loadedPoints) + " points, " +
                                  percent(static_cast<double>(removed) / layer.cleaning->loadedPoints, 2)});
    }
    return table;
}

Table objectTable(const SceneState& scene) {
    Table table;
    table.caption = "Parts of the scene";
    table.columns = {"Part", "Kind", "Layer", "Points", "Length (m)", "Width (m)", "Height (m)"};
    table.numeric = {false, false, false, true, true, true, true};
    for (const SceneObject& object : scene.objects) {
        const Layer* layer = scene.layer(object.layer);
        table.rows.push_back({object.name + (object.visible ? "" : " (hidden)"), object.kind,
                              layer ? layer->name : object.layer, grouped(object.points->size()),
                              fixedText(object.size_m[0], 2), fixedText(object.size_m[1], 2),
                              fixedText(object.size_m[2], 2)});
    }
    return table;
}

std::vector<std::string> waysFound(const SceneState& scene) {
    std::vector<std::string> ways;
    for (const SceneObject& object : scene.objects)
        if (!object.found.empty() && std::find(ways.begin(), ways.end(), object.found) == ways.end())
            ways.push_back(object.found);
    return ways;
}

}  // namespace

Section cleaningSection(const ReportInput& input) {
    Section section{"Cleaning and parts of the scene", {}};
    Table steps = stepsTable(input.scene);
    if (!steps.rows.empty()) {
        section.blocks.push_back(Paragraph{
            "Points that do not belong to the scene were taken out of it before anything was fitted or "
            "measured. The files are unchanged; the fused cloud holds these points, too, with the "
            "flag \u201cwithheld\u201d, so that anyone can put them back and see what was taken."});
        section.blocks.push_back(std::move(steps));
    }
    if (input.scene.objects.empty()) return section;
    section.blocks.push_back(Paragraph{
        "Parts were separated in the clouds by what hangs together, or by hand. Their sizes are those "
        "of the upright box round all of their points, noise included: they help to tell the parts "
        "apart and are no measurements."});
    section.blocks.push_back(objectTable(input.scene));
    constexpr std::size_t kMostWays = 12;
    std::vector<std::string> ways = waysFound(input.scene);
    if (ways.size() > kMostWays) ways.resize(kMostWays);
    for (const std::string& way : ways) section.blocks.push_back(Paragraph{"Found: " + way + "."});
    return section;
}

}  // namespace vestige
