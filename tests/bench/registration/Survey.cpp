#include <time.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "core/base/Units.h"
#include "tests/bench/registration/Trials.h"

namespace vestige::bench {
namespace {

/// Repetitions of a round together last about this long.
constexpr double kRound_s = 0.15;
constexpr int kMostRepetitions = 9;
constexpr std::size_t kLarge = 500000;

double processorTime() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

SettingRun runOnce(const ScanPair& pair, const Contender& contender, double leaf) {
    Trial trial;
    trial.pair = &pair;
    trial.contender = contender;
    trial.leaf_m = leaf;
    Pose found = Pose::Identity();
    const double seconds = timedRun(trial, found).cpu_seconds;
    const SettingRun run{leaf, seconds, poseError(found, pair.reference)};
    std::fprintf(stderr, "  %-28s %5.2f m %9.1f ms  %8.2f mm  %7.3f deg\n", contender.name.c_str(), leaf,
                 1000 * seconds, 1000 * run.error.translation_m, degrees(run.error.rotation_rad));
    return run;
}

}  // namespace

RunTime timedRun(const Trial& trial, Pose& found) {
    const double cpu = processorTime();
    const auto begin = std::chrono::steady_clock::now();
    found = trial.contender.run(*trial.pair, trial.leaf_m, trial.threads);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    return {seconds.count(), processorTime() - cpu};
}

std::vector<Trial> survey(const std::vector<ScanPair>& pairs, const std::vector<int>& threads, int rounds,
                          const std::string& only) {
    std::vector<Trial> trials;
    for (const ScanPair& pair : pairs) {
        std::fprintf(stderr, "%s: every setting once\n", pair.name.c_str());
        PoseError oursError;
        const std::vector<Contender> all = contenders(pair.target.size() > kLarge);
        for (const Contender& contender : all) {
            if (!only.empty() && contender.name != only) continue;
            std::vector<SettingRun> runs;
            for (const double leaf : contender.leaves_m) runs.push_back(runOnce(pair, contender, leaf));
            if (&contender == &all.front()) oursError = runs.front().error;
            const std::size_t counting = *countingSetting(runs, oursError, pair.referenceError);
            for (std::size_t i = 0; i < runs.size(); ++i) {
                if (i != counting && runs[i].leaf_m != contender.asked_m) continue;
                for (const int count : threads) {
                    if (std::find(contender.threads.begin(), contender.threads.end(), count) ==
                        contender.threads.end())
                        continue;
                    Trial trial;
                    trial.pair = &pair;
                    trial.contender = contender;
                    trial.leaf_m = runs[i].leaf_m;
                    trial.threads = count;
                    trial.counts = i == counting;
                    trial.error = runs[i].error;
                    trial.repetitions = std::clamp(static_cast<int>(std::ceil(kRound_s / runs[i].seconds)), 1,
                                                   kMostRepetitions);
                    trial.seconds.resize(static_cast<std::size_t>(rounds));
                    trial.cpu_seconds.resize(static_cast<std::size_t>(rounds));
                    trials.push_back(std::move(trial));
                }
            }
        }
    }
    return trials;
}

}  // namespace vestige::bench
