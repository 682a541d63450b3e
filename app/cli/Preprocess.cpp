#include "core/filters/Preprocess.h"

#include <CLI/App.hpp>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/FilePart.h"
#include "app/cli/Outputs.h"
#include "app/cli/ParameterJson.h"
#include "app/cli/Session.h"
#include "app/cli/WrittenUnit.h"
#include "core/base/Numbers.h"
#include "core/base/Units.h"
#include "core/io/FormatRegistry.h"

namespace vestige::cli {
namespace {

struct Options {
    std::string in;
    std::string out;
    std::string unit = "auto";
    FilePart part;
    ParameterSet parameters{preprocessParameters()};
};

int runPreprocess(Session& session, const Options& options) {
    const auto start = std::chrono::steady_clock::now();
    // A target that cannot be written is a wrong command line, found before the long reading.
    const Result<const FileFormat*> target = formatForWriting(options.out);
    if (!target) return session.failed(target.error());
    if (const Status apart = noInputIsWritten({options.out}, {options.in}); !apart)
        return session.failed(apart.error());
    const JobControl& control = session.control();
    Result<LoadedGeometry> loaded = readPart(options.in, options.part, ReadOptions::Attributes::all,
                                             LoadedFor::command, control.sub(0, 0.3));
    if (!loaded) return session.failed(loaded.error());
    for (const std::string& warning : loaded->info.warnings)
        session.log("warning: " + options.in + ": " + warning);
    const PointCloud& cloud = loaded->geometry.vertices;
    if (loaded->geometry.isMesh())
        session.log(options.in +
                    " is a mesh: its vertices are filtered as points, its triangles are left out");

    const auto given = lengthUnitFromSymbol(options.unit);
    const double metresPerUnit = given ? metresPer(*given) : loaded->info.metresPerUnit.value_or(1);
    const std::string unit(symbol(given ? *given : nearestLengthUnit(metresPerUnit)));
    if (!given && metresPerUnit != 1) session.log(options.in + " is in " + unit + ", as it says");
    const ParameterSet chosen = withChosenRadius(cloud, options.parameters, metresPerUnit, control);
    auto result = preprocess(cloud, chosen, metresPerUnit, control.sub(0.3, 0.8));
    if (!result) return session.failed(result.error());
    const std::size_t outputPoints = result->size();
    LoadedGeometry made{{std::move(*result), {}}, std::move(loaded->info)};
    putIntoUnitOf(**target, options.out, options.in, {metresPerUnit, given.has_value()}, made, session);
    const Status written = writeGeometry(options.out, made.geometry, {&made.info}, control.sub(0.8, 1));
    if (!written) return session.failed(written.error());
    control.progress(1, "writing");
    tellWhatIsLost(options.out, made.info, {}, session);

    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    session.print(options.out + ": " + std::to_string(outputPoints) + " of " + std::to_string(cloud.size()) +
                  " points, " + fixedText(elapsed.count(), 2) + " s");
    session.printJson({{"path", options.out},
                       {"input_points", cloud.size()},
                       {"output_points", outputPoints},
                       {"unit", unit},
                       {"parameters", parametersJson(chosen)},
                       {"seconds", elapsed.count()},
                       {"warnings", made.info.warnings}});
    return 0;
}

}  // namespace

Run declarePreprocess(CLI::App& command) {
    auto options = std::make_shared<Options>();
    command.add_option("IN", options->in, "Cloud to read; of a mesh, its vertices are taken")->required();
    command.add_option("OUT", options->out, "File to write; its extension names the format")->required();
    command
        .add_option(
            "--unit", options->unit,
            "Unit of the coordinates in IN, and in OUT where its format does not fix metres (E57, glTF): " +
                lengthUnitSymbols() +
                " or auto (what IN says, else m); all other lengths are metres. Default: auto.")
        ->check([](const std::string& text) {
            return text == "auto" || lengthUnitFromSymbol(text)
                       ? std::string()
                       : "expected " + lengthUnitSymbols() + " or auto";
        });
    addPartOptions(command, options->part);
    addParameterOptions(command, options->parameters);
    return [options](Session& session) { return runPreprocess(session, *options); };
}

}  // namespace vestige::cli
