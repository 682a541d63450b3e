#include <CLI/App.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/FilePart.h"
#include "app/cli/Outputs.h"
#include "app/cli/Session.h"
#include "app/cli/WrittenUnit.h"
#include "core/io/FormatRegistry.h"

namespace vestige::cli {
namespace {

struct Options {
    std::string in;
    std::string out;
    FilePart part;
    std::optional<double> scale;
    std::vector<double> offset;
};

int runConvert(Session& session, const Options& options) {
    // A target that cannot be written is a wrong command line, found before the long reading.
    const Result<const FileFormat*> target = formatForWriting(options.out);
    if (!target) return session.failed(target.error());
    if (const Status apart = noInputIsWritten({options.out}, {options.in}); !apart)
        return session.failed(apart.error());
    const LoadedFor use = (*target)->writesMetres() ? LoadedFor::metres : LoadedFor::command;
    Result<LoadedGeometry> loaded =
        readPart(options.in, options.part, ReadOptions::Attributes::all, use, session.control().sub(0, 0.6));
    if (!loaded) return session.failed(loaded.error());
    for (const std::string& warning : loaded->info.warnings)
        session.log("warning: " + options.in + ": " + warning);
    FileInfo& info = loaded->info;
    putIntoUnitOf(**target, options.out, options.in, {info.metresPerUnit.value_or(1)}, *loaded, session);
    if (options.scale) info.scale = Eigen::Vector3d::Constant(*options.scale);
    if (options.offset.size() == 3) info.offset = Eigen::Vector3d(options.offset.data());
    const Status written =
        writeGeometry(options.out, loaded->geometry, {&info}, session.control().sub(0.6, 1));
    if (!written) return session.failed(written.error());
    session.control().progress(1, "writing");
    tellWhatIsLost(options.out, info,
                   {options.scale.has_value(), options.offset.size() == 3, loaded->geometry.triangles.size()},
                   session);
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
    command
        .add_option("--scale", options->scale,
                    "Step of the coordinates in OUT, in its unit, where its format has one (LAS, LAZ, E57). "
                    "Default: that of IN.")
        ->check(CLI::Range(1e-9, 1e3));
    command.add_option("--offset", options->offset, "What the steps are counted from. Default: that of IN.")
        ->type_name("X,Y,Z")
        ->delimiter(',')
        ->expected(3);
    return [options](Session& session) { return runConvert(session, *options); };
}

}  // namespace vestige::cli
