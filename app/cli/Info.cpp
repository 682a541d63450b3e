#include <CLI/App.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/Session.h"
#include "core/base/Numbers.h"
#include "core/io/FormatRegistry.h"

namespace vestige::cli {
namespace {

using nlohmann::json;

json triple(const Eigen::Vector3d& values) {
    return json::array({values.x(), values.y(), values.z()});
}

json optionalTriple(const std::optional<Eigen::Vector3d>& values) {
    return values ? triple(*values) : json();
}

json toJson(const FileInfo& info) {
    json object{
        {"path", info.path.string()},
        {"format", info.format},
        {"version", info.version},
        {"points", info.points},
        {"triangles", info.triangles},
        {"bounds", info.bounds.empty()
                       ? json()
                       : json{{"min", triple(info.bounds.min)}, {"max", triple(info.bounds.max)}}},
        {"sha256", info.sha256},
        {"scale", optionalTriple(info.scale)},
        {"offset", optionalTriple(info.offset)},
        {"crs", info.crs.empty() ? json() : json(info.crs)},
        {"attributes", info.attributes},
        {"time_span", info.timeSpan ? json::array({info.timeSpan->first, info.timeSpan->second}) : json()},
        {"warnings", info.warnings}};
    if (info.creationDayYear) {
        object["creation_day"] = info.creationDayYear->first;
        object["creation_year"] = info.creationDayYear->second;
    }
    if (!info.generatingSoftware.empty()) object["generating_software"] = info.generatingSoftware;
    return object;
}

std::string text(const Eigen::Vector3d& values) {
    return exactText(values.x()) + " " + exactText(values.y()) + " " + exactText(values.z());
}

void print(const Session& session, const FileInfo& info) {
    const auto line = [&](const std::string& label, const std::string& value) {
        if (!value.empty()) session.print("  " + label + std::string(12 - label.size(), ' ') + value);
    };
    session.print(info.path.string());
    line("format", info.format + (info.version.empty() ? "" : " " + info.version));
    line("points", std::to_string(info.points));
    if (info.triangles > 0) line("triangles", std::to_string(info.triangles));
    if (!info.bounds.empty()) {
        line("minimum", text(info.bounds.min));
        line("maximum", text(info.bounds.max));
    }
    if (info.scale) line("scale", text(*info.scale));
    if (info.offset) line("offset", text(*info.offset));
    line("CRS", info.crs);
    std::string attributes;
    for (const std::string& name : info.attributes) attributes += (attributes.empty() ? "" : ", ") + name;
    line("attributes", attributes);
    if (info.timeSpan)
        line("time span", exactText(info.timeSpan->first) + " " + exactText(info.timeSpan->second));
    line("written by", info.generatingSoftware);
    line("SHA-256", info.sha256);
    for (const std::string& warning : info.warnings) line("warning", warning);
}

int runInfo(Session& session, const std::vector<std::string>& paths) {
    json files = json::array();
    json failed = json::array();
    int code = 0;
    for (const std::string& path : paths) {
        const Result<FileInfo> info = fileInfo(path, session.control());
        if (info) {
            print(session, *info);
            files.push_back(toJson(*info));
            continue;
        }
        code = session.failed(info.error());
        if (info.error().code == ErrorCode::cancelled) return code;
        failed.push_back({{"path", path}, {"error", info.error().sentence()}});
    }
    json object{{"files", files}};
    if (!failed.empty()) object["failed"] = failed;
    session.printJson(object);
    return code;
}

}  // namespace

Run declareInfo(CLI::App& command) {
    auto paths = std::make_shared<std::vector<std::string>>();
    command.add_option("FILE", *paths, "Clouds and meshes")->required();
    return [paths](Session& session) { return runInfo(session, *paths); };
}

}  // namespace vestige::cli
