#include "core/base/Numbers.h"
#include "core/pipeline/ReconstructRun.h"
#include "core/pipeline/RegisterLayers.h"
#include "core/report/Wording.h"
#include "core/scene/Edits.h"

namespace vestige {
namespace {

/// Below this share of points with a counterpart a fit is told to be doubtful.
constexpr double kPoorOverlap = 0.3;

std::vector<std::string> layersToRegister(const SceneState& scene) {
    std::vector<std::string> ids;
    for (const Layer& layer : scene.layers)
        if (needsRegistration(scene, layer)) ids.push_back(layer.id);
    return ids;
}

void warn(ReconstructRun& run, const JobControl& control, const std::string& text) {
    run.warnings.push_back(text);
    control.message(text);
}

void judge(ReconstructRun& run, const JobControl& control, const Layer& layer) {
    const RegistrationResult& result = *layer.registration;
    for (const auto& note : result.notes) control.message(layer.id + ": " + note);
    if (!result.converged)
        warn(run, control,
             "the registration of " + layer.id + " reached its limit of steps before it settled: doubtful");
    if (result.overlap < kPoorOverlap)
        warn(run, control,
             "only " + percent(result.overlap, 0) + " of the points of " + layer.id +
                 " have a counterpart in the global cloud: doubtful");
    control.message(layer.id + " registered: overlap " + percent(result.overlap, 0) +
                    ", root mean square distance " + fixedText(1000 * result.rmse_m, 1) + " mm");
}

}  // namespace

Status preprocessStage(ReconstructRun& run, const JobControl& control) {
    run.prepared = prepareLayers(run.scene, layersToRegister(run.scene), control);
    for (const auto& [layer, prepared] : run.prepared)
        if (!prepared && prepared.error().code != ErrorCode::untrustworthy) return fail(prepared.error());
    return {};
}

Status registerStage(ReconstructRun& run, const JobControl& control) {
    auto registered =
        registerLayers(run.scene, layersToRegister(run.scene), std::move(run.prepared), control);
    if (!registered) return fail(registered.error());
    for (auto& [id, result] : registered->layers) {
        Layer& layer = *run.scene.layer(id);
        if (!layer.unit)
            layer.unit = result.targetFromSource.scale == 1 ? LengthUnit::metre : LengthUnit::millimetre;
        setRegistration(id, std::move(result))->apply(run.scene);
        judge(run, control, *run.scene.layer(id));
    }
    run.adjustment = std::move(registered->adjustment);
    return {};
}

}  // namespace vestige
