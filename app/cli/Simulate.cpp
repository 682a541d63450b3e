#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "app/cli/Session.h"
#include "core/simulation/SimulateScene.h"
#include "core/simulation/SimulateSequence.h"

namespace vestige::cli {
namespace {

struct Options {
    std::string scene;
    std::string folder;
    std::string frame = "scanner";
    SimulationOptions simulation;
    SequenceOptions sequence;
};

constexpr const char* kPavilion = "pavilion";

int simulateWalk(Session& session, Options options) {
    options.sequence.seed = options.simulation.seed;
    options.sequence.frame = options.frame == "world" ? AslFrame::world : AslFrame::scanner;
    const Result<SimulatedSequence> made =
        simulatePavilion(options.sequence, options.folder, session.control());
    if (!made) return session.failed(made.error());
    std::size_t points = 0;
    for (const std::size_t count : made->points) points += count;
    session.print(std::to_string(made->points.size()) + " scans, " + std::to_string(points) + " points");
    session.printJson(
        {{"scene", kPavilion}, {"folder", options.folder}, {"files", made->files}, {"points", made->points}});
    return 0;
}

int simulate(Session& session, const Options& options) {
    if (options.scene == kPavilion) return simulateWalk(session, options);
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
    command
        .add_option(
            "SCENE", options->scene,
            "two-cars, bicycle, a JSON file that describes a scene, or pavilion: a sequence of scans in "
            "the layout of the ETH ASL data sets, for evaluate.")
        ->required();
    command.add_option("--out", options->folder, "Folder for the clouds, the cases and the truth.")
        ->required();
    command.add_option("--seed", options->simulation.seed, "Seed of everything random. Default: 1.");
    command
        .add_option("--seconds", options->simulation.seconds,
                    "Seconds of flight; the scanner fires 240 000 pulses in each. Default: 40, one circle.")
        ->check(CLI::Range(0.01, 3600.0));
    command.add_option("--scans", options->sequence.scans, "pavilion: scans on the walk. Default: 32.")
        ->check(CLI::Range(2, 200));
    command.add_option("--beams", options->sequence.beams, "pavilion: beams of a scan. Default: 65000.")
        ->check(CLI::Range(1000, 4000000));
    command
        .add_option("--frame", options->frame,
                    "pavilion: clouds in the scanner's frame (Hokuyo_N.csv) or in the world's "
                    "(PointCloudN.csv). Default: scanner.")
        ->check(CLI::IsMember({"scanner", "world"}));
    return [options](Session& session) { return simulate(session, *options); };
}

}  // namespace vestige::cli
