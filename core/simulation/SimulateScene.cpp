#include "core/simulation/SimulateScene.h"

#include "core/base/OutputFolder.h"
#include "core/simulation/SurveyFiles.h"

namespace vestige {
namespace {

/// One case file: the aims that can be made on its layers.
Status writeCase(const Survey& survey, const SceneSpec& spec, const AimOptions& options, bool withHandheld,
                 const std::filesystem::path& folder, SimulatedScene& written) {
    const std::string name = withHandheld ? "case.json" : "case-without-handheld.json";
    const Aiming aiming =
        aimAtFeatures(spec, survey.scene.surfaces, survey.shownLayers(withHandheld), options);
    if (const Status done = writeSimulatedCase(survey, spec, aiming, withHandheld, folder / name); !done)
        return done;
    written.files.push_back(name);
    if (!withHandheld) return {};
    for (const AimedMeasurement& measured : aiming.measurements)
        for (const ShownLayer& layer : survey.shownLayers(false))
            if (!measured.aims.contains(layer.method))
                written.notMeasurable[layer.method].push_back(measured.object);
    return {};
}

}  // namespace

Result<SimulatedScene> simulateScene(const SceneSpec& spec, const SimulationOptions& options,
                                     const std::filesystem::path& folder, const JobControl& control) {
    return guarded(folder.string(), [&]() -> Result<SimulatedScene> {
        const Result<Survey> survey = surveyScene(spec, options.seed, options.seconds, control.sub(0, 0.8));
        if (!survey) return fail(survey.error());
        SimulatedScene written;
        OutputFolder output(folder);
        if (const Status opened = output.open(); !opened) return fail(opened.error());
        const std::filesystem::path& place = output.folder();
        if (const Status done = writeSurveyClouds(*survey, spec, place, control.sub(0.8, 0.98), written);
            !done)
            return fail(done.error());
        AimOptions aims;
        aims.seed = options.seed;
        for (const bool withHandheld : {true, false}) {
            if (!withHandheld && survey->handheld.empty()) continue;
            if (const Status done = writeCase(*survey, spec, aims, withHandheld, place, written); !done)
                return fail(done.error());
        }
        if (const Status done = writeTruth(*survey, spec, options, aims, place / "truth.json"); !done)
            return fail(done.error());
        written.files.push_back("truth.json");
        if (const Status placed = output.commit(); !placed) return fail(placed.error());
        control.progress(1, "done");
        return written;
    });
}

}  // namespace vestige
