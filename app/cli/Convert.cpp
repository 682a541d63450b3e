#include <CLI/App.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/FilePart.h"
#include "app/cli/Session.h"
#include "core/io/FormatRegistry.h"

namespace vestige::cli {
namespace {

struct Options {
    std::string in;
    std::string out;
    FilePart part;
};

int runConvert(Session& session, const Options& options) {
    // A target that cannot be written is a wrong command line, found before the long reading.
    if (const Result<const FileFormat*> target = formatForWriting(options.out); !target)
        return session.failed(target.error());
    const Result<LoadedGeometry> loaded =
        readPart(options.in, options.part, ReadOptions::Attributes::all, session.control().sub(0, 0.6));
    if (!loaded) return session.failed(loaded.error());
    for (const std::string& warning : loaded->info.warnings)
        session.log("warning: " + options.in + ": " + warning);
    const Status written =
        writeGeometry(options.out, loaded->geometry, {&loaded->info}, session.control().sub(0.6, 1));
    if (!written) return session.failed(written.error());
    session.control().progress(1, "writing");
    session.print(
        options.out + ": " + std::to_string(loaded->info.points) + " points" +
        (loaded->info.triangles > 0 ? ", " + std::to_string(loaded->info.triangles) + " triangles" : ""));
    session.printJson({{"path", options.out},
                       {"points", loaded->info.points},
                       {"triangles", loaded->info.triangles},
                       {"warnings", loaded->info.warnings}});
    return 0;
}

}  // namespace

Run declareConvert(CLI::App& command) {
    auto options = std::make_shared<Options>();
    command.add_option("IN", options->in, "Cloud or mesh to read")->required();
    command.add_option("OUT", options->out, "File to write; its extension names the format")->required();
    addPartOptions(command, options->part);
    return [options](Session& session) { return runConvert(session, *options); };
}

}  // namespace vestige::cli
