#include "core/pipeline/joint/AdjustmentJson.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/Units.h"

namespace vestige {
namespace {

using nlohmann::json;

json pairJson(const AdjustedPair& pair) {
    json object{{"to", pair.to}, {"from", pair.from}, {"used", pair.used}, {"reason", pair.whyNot}};
    if (!pair.found) return object;
    const PoseUncertainty aboutPose = pair.uncertainty.about(pair.found->pose.translation());
    object.update({{"pose", rowMajor(pair.found->pose)},
                   {"scale", pair.found->scale},
                   {"overlap", pair.overlap},
                   {"rmse_m", pair.rmse_m},
                   {"covariance", rowMajor(aboutPose.covariance)},
                   {"correction_m", pair.correction_m},
                   {"correction_deg", degrees(pair.correction_rad)},
                   {"controlled", pair.controlled},
                   {"chi_square", pair.chiSquare}});
    return object;
}

/// Standard deviation of a point in the middle of the layer, and of the turn.
json sigmaJson(const PoseUncertainty& uncertainty) {
    return {{"middle_m", std::sqrt(uncertainty.covariance.diagonal().head<3>().sum())},
            {"turn_deg", degrees(std::sqrt(uncertainty.covariance.diagonal().tail<3>().sum()))}};
}

}  // namespace

json adjustmentJson(const JointAdjustment& adjustment) {
    json pairs = json::array();
    for (const AdjustedPair& pair : adjustment.pairs) pairs.push_back(pairJson(pair));
    json loops = json::array();
    for (const AdjustedLoop& loop : adjustment.loops)
        loops.push_back({{"layers", loop.layers},
                         {"translation_m", loop.translation_m},
                         {"rotation_deg", degrees(loop.rotation_rad)},
                         {"chi_square", loop.chiSquare},
                         {"degrees_of_freedom", 6},
                         {"probability", loop.probability}});
    json layers = json::array();
    for (const AdjustedLayer& layer : adjustment.layers)
        layers.push_back({{"layer", layer.layer},
                          {"moved_m", layer.moved_m},
                          {"moved_deg", degrees(layer.moved_rad)},
                          {"sigma_before", sigmaJson(layer.before)},
                          {"sigma_after", sigmaJson(layer.after)}});
    return {{"pairs", std::move(pairs)},
            {"loops", std::move(loops)},
            {"layers", std::move(layers)},
            {"chi_square", adjustment.chiSquare},
            {"degrees_of_freedom", adjustment.degreesOfFreedom},
            {"variance_factor", adjustment.varianceFactor},
            {"consistent", adjustment.consistent}};
}

}  // namespace vestige
