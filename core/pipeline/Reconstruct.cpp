#include "core/pipeline/Reconstruct.h"

#include <array>
#include <variant>

#include "core/base/AtomicFile.h"
#include "core/base/UtcTime.h"
#include "core/pipeline/Manifest.h"
#include "core/pipeline/ReconstructRun.h"

namespace vestige {
namespace {

/// The method, step by step; shares are about the seconds that each takes on a scene of ten million points.
const Recipe<ReconstructRun>& method() {
    static const Recipe<ReconstructRun> recipe{
        {"load", "Reading and indexing the clouds", 10, loadStage},
        {"preprocess", "Cleaning and thinning the global cloud", 10, preprocessStage},
        {"register", "Registering the scans", 15, registerStage},
        {"aim", "Taking recorded aims", 1, aimStage},
        {"measure", "Measuring", 1, measureStage},
        {"fuse", "Writing the fused cloud and the tables", 8, fuseStage},
        {"pictures", "Drawing the pictures", 30, pictureStage},
        {"report", "Setting the report", 5, reportStage},
        {"manifest", "Writing the manifest", 2, manifestStage},
    };
    return recipe;
}

Status checkLayers(const SceneState& scene) {
    const std::string place = scene.file.string();
    if (scene.layers.empty()) return fail(ErrorCode::input, "the case has no layers", place);
    if (!scene.layer(scene.target))
        return fail(ErrorCode::input, "the target \"" + scene.target + "\" is not a layer of the case", place,
                    "\"registration\": {\"target\": ...} names the layer that the others are registered to");
    return {};
}

/// No result may take the place of what it was computed from, and none of an earlier run that is an input now
/// may go.
Status checkApart(const std::vector<InputFile>& inputs, const std::filesystem::path& folder,
                  const std::vector<OutputFile>& outputs, const std::vector<std::string>& obsolete) {
    std::vector<std::string> touched = obsolete;
    for (const OutputFile& output : outputs) touched.push_back(output.path);
    for (const std::string& name : touched)
        for (const InputFile& input : inputs)
            if (samePlace(folder / name, input.path))
                return fail(ErrorCode::usage, "a result would replace " + input.what + ", an input",
                            (folder / name).string(), "inputs are only ever read; expected: another folder");
    return {};
}

/// Of results that every run makes, before any is computed; what the run will make is known at its end.
constexpr std::array kAlwaysMade{"fused.las",        "report.pdf",   "registration.json",
                                 "measurements.csv", "accuracy.csv", "manifest.json"};

Status checkApartEarly(const SceneState& scene, const std::filesystem::path& folder) {
    std::vector<InputFile> inputs;
    for (const Layer& layer : scene.layers) {
        inputs.push_back({"layer " + layer.id, scene.resolve(layer.path), {}, {}});
        if (const auto* picks = std::get_if<InitPicks>(&layer.init))
            inputs.push_back({"picks of " + layer.id, scene.resolve(picks->picks), {}, {}});
    }
    std::vector<std::string> names(kAlwaysMade.begin(), kAlwaysMade.end());
    return checkApart(inputs, folder, {}, names);
}

}  // namespace

Result<Reconstruction> reconstruct(SceneState scene, const std::filesystem::path& outputFolder,
                                   ViewRenderer* renderer, DocumentPrinter* printer,
                                   const JobControl& control, SceneState* reached) {
    if (const Status checked = checkLayers(scene); !checked) return fail(checked.error());
    if (const Status apart = checkApartEarly(scene, outputFolder); !apart) return fail(apart.error());
    ReconstructRun run{std::move(scene),
                       OutputFolder(outputFolder),
                       renderer,
                       printer,
                       utcNow(),
                       {},
                       {},
                       {},
                       {},
                       {},
                       {},
                       {},
                       {},
                       {}};
    if (const Status opened = run.output.open(); !opened) return fail(opened.error());

    Reconstruction result;
    const Status done = runRecipe(method(), run, control, [&](const auto& stage, double seconds) {
        run.stages.push_back({stage.title, seconds});
        result.secondsPerStage[stage.id] = seconds;
    });
    if (!done) {
        if (reached) *reached = std::move(run.scene);
        return fail(done.error());
    }
    result.outputs = std::move(run.outputs);
    const std::vector<std::string> obsolete = obsoleteOutputs(outputFolder, result.outputs);
    if (const Status apart = checkApart(run.inputs, outputFolder, result.outputs, obsolete); !apart)
        return fail(apart.error());
    if (const Status placed = run.output.commit(obsolete); !placed) return fail(placed.error());
    result.scene = std::move(run.scene);
    result.measured = std::move(run.measured);
    result.notMade = std::move(run.notMade);
    result.warnings = std::move(run.warnings);
    return result;
}

}  // namespace vestige
