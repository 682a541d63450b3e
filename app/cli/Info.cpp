#include <CLI/App.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/InfoText.h"
#include "app/cli/Session.h"
#include "core/io/FormatRegistry.h"

namespace vestige::cli {
namespace {

using nlohmann::json;

struct Options {
    std::vector<std::string> paths;
    bool quick = false;
};

int runInfo(Session& session, const Options& options) {
    json files = json::array();
    json failed = json::array();
    int code = 0;
    for (const std::string& path : options.paths) {
        const Result<FileInfo> info =
            options.quick ? peekFile(path, session.control()) : fileInfo(path, session.control());
        if (info) {
            printInfo(session, *info);
            files.push_back(infoJson(*info));
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
    auto options = std::make_shared<Options>();
    command.add_option("FILE", options->paths, "Clouds and meshes")->required();
    command.add_flag("--quick", options->quick,
                     "Only what the head of a file says, at once: no points are read and checked, and there "
                     "is no SHA-256; a format that cannot tell gives 0 points.");
    return [options](Session& session) { return runInfo(session, *options); };
}

}  // namespace vestige::cli
