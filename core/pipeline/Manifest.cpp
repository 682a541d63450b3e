#include "core/pipeline/Manifest.h"

#include <Eigen/Core>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/AtomicFile.h"
#include "core/base/Hash.h"
#include "core/base/Parallel.h"
#include "core/base/Version.h"

namespace vestige {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

json parameterJson(const ParameterSet& parameters) {
    json object = json::object();
    for (const auto& spec : parameters.table())
        object[spec.key] = std::visit(
            [](const auto& value) -> json {
                if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::monostate>)
                    return nullptr;
                else
                    return value;
            },
            parameters.value(spec.key));
    return object;
}

/// A name that stays inside the folder it is relative to.
bool staysInside(const fs::path& name) {
    return !name.empty() && name.is_relative() &&
           std::none_of(name.begin(), name.end(), [](const fs::path& part) { return part == ".."; });
}

}  // namespace

std::vector<std::pair<std::string, std::string>> softwareVersions(const ViewRenderer* renderer,
                                                                  const DocumentPrinter* printer) {
    std::vector<std::pair<std::string, std::string>> versions{
        {"Vestige", kVersion},
        {"Compiler", __VERSION__},
        {"Eigen", std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
                      std::to_string(EIGEN_MINOR_VERSION)}};
    if (renderer && !renderer->version().empty()) versions.emplace_back("Pictures", renderer->version());
    if (printer && !printer->version().empty()) versions.emplace_back("Report", printer->version());
    return versions;
}

std::string manifestText(const ReconstructRun& run, const std::vector<OutputFile>& outputs) {
    json manifest;
    manifest["vestige"] = 1;
    manifest["case"] = {{"name", run.scene.name}, {"operator", run.scene.operatorName}};
    manifest["started"] = run.date;
    for (const auto& input : run.inputs) {
        json entry{{"what", input.what}, {"path", input.path.string()}, {"sha256", input.sha256}};
        if (!input.expectedSha256.empty()) entry["expected_sha256"] = input.expectedSha256;
        manifest["inputs"].push_back(std::move(entry));
    }
    for (const auto& output : outputs)
        manifest["outputs"].push_back({{"path", output.path}, {"sha256", output.sha256}});
    manifest["not_made"] = run.notMade;
    for (const auto& [component, version] : softwareVersions(run.renderer, run.printer))
        manifest["versions"][component] = version;
    manifest["parameters"] = {{"preprocess", parameterJson(run.scene.preprocess)},
                              {"registration", parameterJson(run.scene.registration)},
                              {"threads", threadCount()}};
    for (const auto& stage : run.stages)
        manifest["stages"].push_back({{"title", stage.title}, {"seconds", stage.seconds}});
    manifest["warnings"] = run.warnings;
    return manifest.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

Result<std::vector<OutputFile>> hashedOutputs(OutputFolder& output, const JobControl& control) {
    std::vector<OutputFile> files;
    const auto names = output.files();
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto count = static_cast<double>(names.size());
        const auto hash =
            sha256OfFile(output.path(names[i]),
                         control.sub(static_cast<double>(i) / count, static_cast<double>(i + 1) / count));
        if (!hash) return fail(hash.error());
        files.push_back({names[i], *hash});
    }
    return files;
}

std::vector<std::string> obsoleteOutputs(const fs::path& folder, const std::vector<OutputFile>& outputs) {
    std::vector<std::string> obsolete;
    const auto text = readTextFile(folder / "manifest.json", std::size_t{16} << 20);
    if (!text) return obsolete;
    const json manifest = json::parse(*text, nullptr, false);
    if (!manifest.is_object() || !manifest.contains("outputs") || !manifest["outputs"].is_array())
        return obsolete;
    for (const json& entry : manifest["outputs"]) {
        if (!entry.is_object() || !entry.contains("path") || !entry["path"].is_string() ||
            !entry.contains("sha256"))
            continue;
        const std::string name = entry["path"];
        const bool madeAgain = std::any_of(outputs.begin(), outputs.end(),
                                           [&](const OutputFile& output) { return output.path == name; });
        std::error_code unknown;
        if (madeAgain || !staysInside(name) || !fs::is_regular_file(folder / name, unknown)) continue;
        if (const auto hash = sha256OfFile(folder / name); hash && entry["sha256"] == *hash)
            obsolete.push_back(name);
    }
    return obsolete;
}

}  // namespace vestige
