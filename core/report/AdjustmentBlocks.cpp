#include "core/report/AdjustmentBlocks.h"

#include <cmath>

#include "core/base/Numbers.h"
#include "core/base/Units.h"
#include "core/report/Wording.h"

namespace vestige {
namespace {

std::string nameOf(const SceneState& scene, const std::string& id) {
    const Layer* layer = scene.layer(id);
    return layer ? layer->name : id;
}

std::string millimetres(double metres) {
    return fixedText(1000 * metres, 1);
}

std::string turn(double radians) {
    return fixedText(degrees(radians), 3);
}

std::string probabilityText(double probability) {
    return probability < 0.001 ? "below 0.001" : fixedText(probability, 3);
}

double sigma(const PoseUncertainty& uncertainty) {
    return std::sqrt(uncertainty.covariance.diagonal().head<3>().sum());
}

Table pairTable(const JointAdjustment& adjustment, const SceneState& scene) {
    Table table;
    table.caption = "Pairs, and by how much the adjustment corrected them";
    table.columns = {"Pair", "Overlap", "RMS (mm)", "Corrected (mm)", "Corrected (\u00b0)", "Used"};
    table.numeric = {false, true, true, true, true, false};
    table.widths = {3, 1, 1, 1.3, 1.3, 3};
    for (const AdjustedPair& pair : adjustment.pairs) {
        if (!pair.used) table.emphasised.push_back(table.rows.size());
        const std::string used = pair.used ? "yes" : "no: " + pair.whyNot;
        const std::string name = nameOf(scene, pair.from) + " to " + nameOf(scene, pair.to);
        if (pair.found)
            table.rows.push_back({name, percent(pair.overlap, 0), millimetres(pair.rmse_m),
                                  millimetres(pair.correction_m), turn(pair.correction_rad), used});
        else
            table.rows.push_back({name, "\u2013", "\u2013", "\u2013", "\u2013", used});
    }
    return table;
}

Table loopTable(const JointAdjustment& adjustment, const SceneState& scene) {
    Table table;
    table.caption = "Loops, and by how much they failed to close before the adjustment";
    table.columns = {"Loop", "Closure (mm)", "Closure (\u00b0)", "\u03c7\u00b2 (6)", "Probability"};
    table.numeric = {false, true, true, true, true};
    table.widths = {5, 1.2, 1.2, 1, 1.2};
    for (const AdjustedLoop& loop : adjustment.loops) {
        std::string name;
        for (const std::string& id : loop.layers) name += nameOf(scene, id) + " \u2013 ";
        table.rows.push_back({name + nameOf(scene, loop.layers.front()), millimetres(loop.translation_m),
                              turn(loop.rotation_rad), fixedText(loop.chiSquare, 1),
                              probabilityText(loop.probability)});
    }
    return table;
}

Table layerTable(const JointAdjustment& adjustment, const SceneState& scene) {
    Table table;
    table.caption = "Standard deviation of a layer's place (at its middle) before and after the adjustment";
    table.columns = {"Layer", "Before (mm)", "After (mm)", "Moved (mm)", "Turned (\u00b0)"};
    table.numeric = {false, true, true, true, true};
    for (const AdjustedLayer& layer : adjustment.layers)
        table.rows.push_back({nameOf(scene, layer.layer), millimetres(sigma(layer.before)),
                              millimetres(sigma(layer.after)), millimetres(layer.moved_m),
                              turn(layer.moved_rad)});
    return table;
}

}  // namespace

std::vector<Block> adjustmentBlocks(const JointAdjustment& adjustment, const SceneState& scene) {
    std::string text =
        "Layers that overlap were registered pair by pair, and all their poses were then adjusted together "
        "by "
        "least squares, each pair with its own covariance; the global cloud is held. Before the adjustment a "
        "closed way through the pairs fails to end where it began: that is the loop's closure.";
    if (adjustment.degreesOfFreedom > 0)
        text += " The sum of squares is " + fixedText(adjustment.chiSquare, 1) + " with " +
                std::to_string(adjustment.degreesOfFreedom) + " degrees of freedom (variance factor " +
                fixedText(adjustment.varianceFactor, 2) +
                (adjustment.consistent
                     ? "): the pairs agree within their covariances."
                     : "): the pairs disagree by more than their covariances allow, which were made larger "
                       "by that factor.");
    else
        text += " No loop closes here, so nothing controls the pairs.";
    std::vector<Block> blocks{Paragraph{text}, pairTable(adjustment, scene)};
    if (!adjustment.loops.empty()) blocks.push_back(loopTable(adjustment, scene));
    blocks.push_back(layerTable(adjustment, scene));
    return blocks;
}

}  // namespace vestige
