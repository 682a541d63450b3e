#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/AtomicFile.h"
#include "core/base/Hash.h"
#include "core/io/LasWriter.h"
#include "core/pipeline/LoadLayers.h"
#include "core/pipeline/ReconstructRun.h"
#include "core/pipeline/RegistrationsJson.h"
#include "core/pipeline/joint/AdjustmentJson.h"
#include "core/report/AccuracyCsv.h"
#include "core/report/MeasurementsCsv.h"
#include "core/report/QuantitiesCsv.h"
#include "core/scene/Cleaning.h"

namespace vestige {
namespace {

using nlohmann::json;

/// A VLR with a line `number TAB id TAB name` for each layer.
CrsRecord layerNames(const SceneState& scene) {
    std::string text;
    for (std::size_t i = 0; i < scene.layers.size(); ++i)
        text += std::to_string(i + 1) + "\t" + scene.layers[i].id + "\t" + scene.layers[i].name + "\n";
    // A record that is no EVLR holds 65535 bytes at most.
    text.resize(std::min<std::size_t>(text.size(), 65535));
    return {"Vestige", 1, "layer names", {text.begin(), text.end()}, false};
}

/// What the header says: nothing that differs from run to run.
LasWriteOptions headerOf(const SceneState& scene) {
    LasWriteOptions options;
    Sha256 hash;
    std::pair<int, int> newest{0, 0};  // year, day
    for (const Layer& layer : scene.layers) {
        hash.add(layer.data->sha256);
        if (layer.role != LayerRole::aerial || !layer.data->info.creationDayYear) continue;
        const auto [day, year] = *layer.data->info.creationDayYear;
        newest = std::max(newest, {year, day});
    }
    options.creationYear = newest.first;
    options.creationDay = newest.second;
    const auto digest = hash.digest();
    std::copy_n(digest.begin(), options.guid.size(), options.guid.begin());
    const Layer& targetLayer = *scene.layer(scene.target);
    const FileInfo& target = targetLayer.data->info;
    // The fused cloud is in metres: a reference system in feet is no longer its own.
    if (targetLayer.metresPerUnit() == 1) options.crsRecords = target.crsRecords;
    options.gpsTimeIsAdjustedStandard = target.gpsTimeIsAdjustedStandard;
    options.extraRecords = {layerNames(scene)};
    return options;
}

/// The original points, with all their attributes, of the target and of every layer registered to it, where
/// the scene has them. What cleaning took out is there, too, withheld.
std::vector<LasPart> partsOf(const SceneState& scene) {
    std::vector<LasPart> parts;
    for (std::size_t i = 0; i < scene.layers.size(); ++i) {
        const Layer& layer = scene.layers[i];
        if (layer.id == scene.target || layer.registration)
            parts.push_back({loadedData(layer)->points.get(), sceneFromLayer(layer),
                             static_cast<std::uint16_t>(i + 1),
                             [&layer, file = scene.resolve(layer.path)](const JobControl& control) {
                                 Layer loaded = layer;
                                 loaded.data = loadedData(layer);
                                 return allAttributes(loaded, file, control);
                             },
                             layer.cleaning ? &layer.cleaning->removed : nullptr});
    }
    return parts;
}

std::string textOf(const json& tree) {
    return tree.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace

Status fuseStage(ReconstructRun& run, const JobControl& control) {
    if (run.scene.layers.size() > 65535)
        return fail(ErrorCode::input, "a fused cloud holds 65535 layers at most", run.scene.file.string());
    const Status fused =
        writeLas(run.output.path("fused.las"), partsOf(run.scene), headerOf(run.scene), control);
    if (!fused) return fused;
    const std::pair<const char*, std::string> tables[] = {
        {"registration.json", textOf(registrationsJson(run.scene, false))},
        {"measurements.csv", measurementsCsv(run.measured)},
        {"quantities.csv", quantitiesCsv(run.measured)},
        {"uncertainty.csv", uncertaintyCsv(run.measured)},
        {"accuracy.csv", accuracyCsv(run.measured.accuracy)}};
    for (const auto& [name, text] : tables)
        if (const Status written = writeTextFile(run.output.path(name), text); !written) return written;
    if (!run.adjustment) return {};
    return writeTextFile(run.output.path("adjustment.json"), textOf(adjustmentJson(*run.adjustment)));
}

}  // namespace vestige
