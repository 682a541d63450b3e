#include "core/base/Hash.h"
#include "core/pipeline/LoadLayers.h"
#include "core/pipeline/ReconstructRun.h"
#include "core/scene/CaseFile.h"
#include "core/scene/CleanedData.h"

namespace vestige {
namespace {

/// The case and picks files, too, are what the results come from.
Status hashSideFiles(ReconstructRun& run) {
    const auto add = [&run](const std::string& what, const std::filesystem::path& file) -> Status {
        const auto hash = sha256OfFile(file);
        if (!hash) return fail(hash.error());
        run.inputs.push_back({what, file, *hash, {}});
        return {};
    };
    if (const auto& file = run.scene.file; !file.empty()) {
        // A case that was not saved yet has none.
        if (const auto content = caseContent(file))
            run.inputs.push_back({"case", content->first, content->second, {}});
    }
    for (const Layer& layer : run.scene.layers)
        if (const auto* picks = std::get_if<InitPicks>(&layer.init))
            if (const Status added = add("picks of " + layer.id, run.scene.resolve(picks->picks)); !added)
                return added;
    return {};
}

}  // namespace

Status loadStage(ReconstructRun& run, const JobControl& control) {
    if (const Status hashed = hashSideFiles(run); !hashed) return hashed;
    auto& layers = run.scene.layers;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const auto file = run.scene.resolve(layers[i].path);
        const auto count = static_cast<double>(layers.size());
        const JobControl sub =
            control.sub(static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
        sub.progress(0, "reading " + file.filename().string());
        if (!layers[i].data || layers[i].data->isPreview()) {
            auto data = loadLayer(layers[i], file, sub);
            if (!data) return fail(data.error());
            layers[i].data = std::move(*data);
        }
        if (const Status cleaned = applyCleaning(layers[i], sub.sub(0.9, 1)); !cleaned) return cleaned;
        const std::size_t place = run.inputs.size();
        run.inputs.push_back({"layer " + layers[i].id, file, layers[i].data->sha256, {}});
        const LayerData& data = *layers[i].data;
        for (std::size_t k = 0; k < data.companionSha256.size(); ++k)
            run.inputs.push_back(
                {"part of layer " + layers[i].id, data.info.companions[k], data.companionSha256[k], {}});
        if (const auto difference = evidenceDifference(layers[i])) {
            run.inputs[place].expectedSha256 = layers[i].evidence->sha256;
            run.warnings.push_back(*difference);
            control.message("warning: " + run.warnings.back());
        }
        for (const auto& warning : layers[i].data->info.warnings) {
            run.warnings.push_back(file.filename().string() + ": " + warning);
            control.message(run.warnings.back());
        }
    }
    return {};
}

}  // namespace vestige
