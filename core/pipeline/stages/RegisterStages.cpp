#include "core/base/Numbers.h"
#include "core/pipeline/ReconstructRun.h"
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

/// The part of a stage's progress that the i-th of `count` layers takes.
JobControl partOf(const JobControl& control, std::size_t i, std::size_t count) {
    return control.sub(static_cast<double>(i) / static_cast<double>(count),
                       static_cast<double>(i + 1) / static_cast<double>(count));
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
    const auto ids = layersToRegister(run.scene);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        auto prepared = prepareRegistration(run.scene, ids[i], partOf(control, i, ids.size()));
        if (!prepared) return fail(prepared.error());
        run.prepared.emplace(ids[i], std::move(*prepared));
    }
    return {};
}

Status registerStage(ReconstructRun& run, const JobControl& control) {
    const auto ids = layersToRegister(run.scene);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        auto result =
            registerPrepared(run.scene, ids[i], run.prepared.at(ids[i]), partOf(control, i, ids.size()));
        if (!result) return fail(result.error());
        run.prepared.erase(ids[i]);
        Layer& layer = *run.scene.layer(ids[i]);
        if (!layer.unit)
            layer.unit = result->targetFromSource.scale == 1 ? LengthUnit::metre : LengthUnit::millimetre;
        setRegistration(ids[i], std::move(*result))->apply(run.scene);
        judge(run, control, *run.scene.layer(ids[i]));
    }
    return {};
}

}  // namespace vestige
