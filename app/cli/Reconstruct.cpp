#include "core/pipeline/Reconstruct.h"

#include <CLI/App.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/cli/Session.h"
#include "app/offscreen/OffscreenApplication.h"
#include "core/base/Numbers.h"
#include "core/pipeline/RegistrationsJson.h"
#include "core/report/CheckBlocks.h"
#include "core/report/ChecksJson.h"
#include "core/report/QuantityText.h"
#include "core/report/ResultsJson.h"
#include "core/report/Wording.h"
#include "core/scene/CaseFile.h"
#include "core/scene/Cleaning.h"
#include "ui/print/PdfPrinter.h"

namespace vestige::cli {
namespace {

using nlohmann::json;

struct Options {
    std::string file;
    std::string out;
};

json layersJson(const SceneState& scene) {
    json list = json::array();
    for (std::size_t i = 0; i < scene.layers.size(); ++i) {
        const Layer& layer = scene.layers[i];
        list.push_back({{"number", i + 1},
                        {"id", layer.id},
                        {"name", layer.name},
                        {"role", std::string(name(layer.role))},
                        {"method", layer.method},
                        {"path", layer.path.string()},
                        {"unit", std::string(symbol(layer.lengthUnit()))},
                        {"points", loadedData(layer)->points->size()},
                        {"removed", layer.cleaning ? layer.cleaning->removed.size() : 0},
                        {"triangles", layer.data->geometry->triangles.size()},
                        {"sha256", layer.data->sha256},
                        {"sha256_expected", layer.evidence ? json(layer.evidence->sha256) : json()},
                        {"changed", evidenceDifference(layer).has_value()},
                        {"target", layer.id == scene.target},
                        {"registered", layer.registration.has_value()}});
    }
    return list;
}

json resultJson(const Reconstruction& result) {
    json outputs = json::array();
    for (const auto& output : result.outputs)
        outputs.push_back({{"path", output.path}, {"sha256", output.sha256}});
    return {{"layers", layersJson(result.scene)},
            {"registration", registrationsJson(result.scene, true)},
            {"measurements", measurementsJson(result.measured)},
            {"accuracy", accuracyJson(result.measured.accuracy)},
            {"quantities", quantitiesJson(result.measured)},
            {"checks", checksJson(result.measured)},
            {"outputs", std::move(outputs)},
            {"not_made", result.notMade},
            {"warnings", result.warnings},
            {"seconds", result.secondsPerStage}};
}

void printForPeople(const Session& session, const Reconstruction& result, const std::string& out) {
    for (const auto& length : result.measured.lengths) {
        std::string line = length.object + ", " + length.method + ": ";
        if (length.length) {
            const auto& u = length.length->expandedUncertainty_m;
            line += exactText(length.length->mean_m) + " m";
            if (u) line += " \u00b1 " + exactText(*u);
            if (length.re) line += ", RE " + exactText(*length.re);
            if (length.excluded) line += " (excluded)";
        } else {
            line += "not measurable";
        }
        session.print(line);
    }
    for (const auto& method : result.measured.accuracy) {
        if (!method.rmse) continue;
        session.print(method.name + ": RMSE " + exactText(*method.rmse) + " over " +
                      howMany(method.n - method.excluded.size(), "object") +
                      (method.excluded.empty() ? "" : ", without " + listed(method.excluded)) + "; of all " +
                      exactText(method.rmseAll.value_or(0)));
    }
    for (const auto& kind : result.measured.kinds) {
        if (kind.kind == MeasurementKind::distance) continue;
        for (const auto& quantity : kind.quantities)
            session.print(kind.object + ", " + kind.method + ", " + quantity.label + ": " +
                          quantitySentence(quantity));
    }
    session.print(verificationSentence(result.measured));
    session.print(howMany(result.outputs.size(), "file") + " in " + out);
}

int run(Session& session, const Options& options) {
    std::vector<std::string> warnings;
    auto scene = readCase(options.file, &warnings);
    if (!scene) return session.failed(scene.error());
    for (const auto& warning : warnings) session.log(warning);
    const OffscreenApplication application;
    const auto renderer = offscreenRenderer();
    PdfPrinter printer;
    SceneState reached;
    const auto result =
        reconstruct(std::move(*scene), options.out, renderer.get(), &printer, session.control(), &reached);
    if (!result) {
        const bool loaded = std::all_of(reached.layers.begin(), reached.layers.end(),
                                        [](const Layer& layer) { return layer.data != nullptr; });
        if (result.error().code == ErrorCode::untrustworthy && loaded)
            session.printJson(
                {{"layers", layersJson(reached)}, {"registration", registrationsJson(reached, true)}});
        return session.failed(result.error());
    }
    for (const auto& missing : result->notMade) session.log("not made: " + missing);
    for (const auto& failed : failedChecks(result->measured)) session.log("WARNING: " + failed);
    printForPeople(session, *result, options.out);
    session.printJson(resultJson(*result));
    return 0;
}

}  // namespace

Run declareReconstruct(CLI::App& command) {
    const auto options = std::make_shared<Options>();
    command
        .add_option("CASE", options->file,
                    "The case: a case.json, or a folder or file NAME.vestige that the workstation saved.")
        ->required();
    command
        .add_option("--out", options->out,
                    "Folder for the results; made when it is missing. Files of the same names are replaced, "
                    "at the end "
                    "and all together.")
        ->required()
        ->type_name("DIR");
    return [options](Session& session) { return run(session, *options); };
}

}  // namespace vestige::cli
