// Registration from points in memory to the pose: ours beside PCL's and Open3D's, round by round.
//
//   bench_registration [--pairs=street,room,...] [--rounds=5] [--threads=1,2] [--only=METHOD]
//                      [--pair=TARGET,SOURCE,REFERENCE[,START]]... [--markdown=FILE]
//                      [Google Benchmark's own options]
//
// First every setting runs once, which fixes the errors (they do not depend on chance) and the setting that
// each peer counts with. Then the rounds: each contender once per round, so that a change of the machine's
// load hits all alike; ratios are taken within a round.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <fstream>
#include <sstream>

#include "tests/bench/registration/Machine.h"
#include "tests/bench/registration/Trials.h"

namespace {

using namespace vestige::bench;

/// A machine this loaded has no second core to give.
constexpr double kMostLoad = 1.2;

struct Options {
    std::vector<std::string> pairs = pairNames();
    std::vector<std::string> files;  ///< pairs of files, for pairOfFiles
    std::vector<int> threads{1, 2};
    int rounds = 5;
    std::string only;
    std::string markdown;
};

std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> parts;
    std::stringstream stream(text);
    for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
    return parts;
}

/// Takes our options out of argv; false with a sentence when one is unknown.
bool parse(int& argc, char** argv, Options& options) {
    int kept = 1;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        const std::size_t equals = argument.find('=');
        const std::string key = argument.substr(0, equals);
        const std::string value = equals == std::string::npos ? "" : argument.substr(equals + 1);
        if (key == "--pairs") {
            options.pairs = split(value);
        } else if (key == "--pair") {
            options.files.push_back(value);
        } else if (key == "--threads") {
            options.threads.clear();
            for (const std::string& count : split(value)) options.threads.push_back(std::stoi(count));
        } else if (key == "--rounds") {
            options.rounds = std::stoi(value);
        } else if (key == "--only") {
            options.only = value;
        } else if (key == "--markdown") {
            options.markdown = value;
        } else {
            argv[kept++] = argv[i];
        }
    }
    argc = kept;
    return options.rounds > 0;
}

void measure(benchmark::State& state, Trial& trial, std::size_t round) {
    if (trial.threads > 1 && loadAverage() > kMostLoad) {
        ++trial.refused;
        state.SkipWithError("refused: the machine is loaded, two threads would not get two cores");
        return;
    }
    for (auto _ : state) {
        vestige::Pose found = vestige::Pose::Identity();
        const RunTime time = timedRun(trial, found);
        state.SetIterationTime(time.seconds);
        trial.seconds[round].push_back(time.seconds);
        trial.cpu_seconds[round].push_back(time.cpu_seconds);
    }
    state.counters["error_mm"] = 1000 * trial.error.translation_m;
}

void registerRounds(std::vector<Trial>& trials, int rounds) {
    for (int round = 0; round < rounds; ++round) {
        for (Trial& trial : trials) {
            std::string name =
                "round " + std::to_string(round + 1) + "/" + trial.pair->name + "/" + trial.contender.name;
            if (trial.leaf_m > 0) name += "/" + std::to_string(trial.leaf_m).substr(0, 4) + " m";
            name += "/" + std::to_string(trial.threads) + " thread" + (trial.threads > 1 ? "s" : "");
            benchmark::RegisterBenchmark(name.c_str(),
                                         [&trial, round](benchmark::State& state) {
                                             measure(state, trial, static_cast<std::size_t>(round));
                                         })
                ->UseManualTime()
                ->Iterations(trial.repetitions)
                ->Unit(benchmark::kMillisecond);
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    if (!parse(argc, argv, options)) return 2;
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    const std::string machine = describeMachine();
    std::fputs(machine.c_str(), stderr);
    std::vector<ScanPair> pairs = loadPairs(options.pairs);
    for (const std::string& files : options.files) pairs.push_back(pairOfFiles(files));
    std::vector<Trial> trials = survey(pairs, options.threads, options.rounds, options.only);
    registerRounds(trials, options.rounds);
    benchmark::RunSpecifiedBenchmarks();
    const std::string tables = machine + "- " + std::to_string(options.rounds) +
                               " rounds, contenders interleaved\n" + markdown(pairs, trials);
    if (options.markdown.empty())
        std::fputs(tables.c_str(), stdout);
    else
        std::ofstream(options.markdown) << tables;
    return 0;
}
