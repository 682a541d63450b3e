#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "app/cli/Session.h"
#include "core/simulation/SimulateScene.h"

namespace vestige::cli {
namespace {

struct Options {
    std::string scene;
    std::string folder;
    SimulationOptions simulation;
};

int simulate(Session& session, const Options& options) {
    const Result<SceneSpec> spec = sceneSpec(options.scene);
    if (!spec) return session.failed(spec.error());
    const Result<SimulatedScene> made =
        simulateScene(*spec, options.simulation, options.folder, session.control());
    if (!made) return session.failed(made.error());
    for (const auto& [layer, points] : made->points)
        session.print(layer + ": " + std::to_string(points) + " points");
    for (const auto& [method, objects] : made->notMeasurable)
        for (const std::string& object : objects)
            session.print("not measurable by " + method + ": " + object);
    session.printJson({{"scene", spec->name},
                       {"folder", options.folder},
                       {"files", made->files},
                       {"points", made->points},
                       {"not_measurable", made->notMeasurable}});
    return 0;
}

}  // namespace

Run declareSimulate(CLI::App& command) {
    auto options = std::make_shared<Options>();
    command.add_option("SCENE", options->scene, "two-cars, bicycle, or a JSON file that describes a scene.")
        ->required();
    command.add_option("--out", options->folder, "Folder for the clouds, the cases and the truth.")
        ->required();
    command.add_option("--seed", options->simulation.seed, "Seed of everything random. Default: 1.");
    command
        .add_option("--seconds", options->simulation.seconds,
                    "Seconds of flight; the scanner fires 240 000 pulses in each. Default: 40, one circle.")
        ->check(CLI::Range(0.01, 3600.0));
    return [options](Session& session) { return simulate(session, *options); };
}

}  // namespace vestige::cli
