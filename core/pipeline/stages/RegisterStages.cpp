#include "core/base/Numbers.h"
#include "core/pipeline/ReconstructRun.h"
#include "core/pipeline/RegisterLayers.h"
#include "core/report/Wording.h"
#include "core/scene/Edits.h"
#include "core/scene/LayerUnit.h"

namespace vestige {
namespace {

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
    if (result.verdict == Verdict::doubtful) {
        std::string text = "the registration of " + layer.id + " is doubtful";
        for (const auto& reason : result.reasons)
            text += (&reason == &result.reasons.front() ? ": " : "; ") + reason;
        warn(run, control, text);
    }
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
    auto attempted = attemptLayers(run.scene, layersToRegister(run.scene), std::move(run.prepared), control);
    if (!attempted) return fail(attempted.error());
    std::optional<Error> failure;
    for (auto& [id, result, why] : attempted->layers) {
        if (why && (!failure || failure->code == ErrorCode::untrustworthy)) failure = why;
        if (!result) continue;
        Layer& layer = *run.scene.layer(id);
        noteUnit(layer, result->targetFromSource.scale);
        setRegistration(id, std::move(*result))->apply(run.scene);
        if (!why) judge(run, control, *run.scene.layer(id));
    }
    if (failure) return fail(*failure);
    run.adjustment = std::move(attempted->adjustment);
    return {};
}

}  // namespace vestige
