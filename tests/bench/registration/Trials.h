#pragma once

#include <string>
#include <vector>

#include "tests/bench/registration/Contenders.h"
#include "tests/bench/registration/Pairs.h"
#include "tests/bench/registration/Scores.h"

namespace vestige::bench {

/// One contender at one setting and number of threads on one pair: what the rounds measure.
struct Trial {
    const ScanPair* pair = nullptr;
    Contender contender;
    double leaf_m = 0;
    int threads = 1;
    bool counts = true;  ///< false: shown because asked for, a better setting counts
    PoseError error;
    int repetitions = 1;     ///< in a round; more for what takes little time
    RoundTimes seconds;      ///< wall time, [round][repetition]
    RoundTimes cpu_seconds;  ///< processor time of all threads
    int refused = 0;         ///< rounds that the machine was too loaded for
};

struct RunTime {
    double seconds = 0;
    double cpu_seconds = 0;
};

/// Runs every contender (or the one named `only`) once at each of its settings, and picks those that the
/// rounds measure.
std::vector<Trial> survey(const std::vector<ScanPair>& pairs, const std::vector<int>& threads, int rounds,
                          const std::string& only = {});

/// One run; `found` is what it found.
RunTime timedRun(const Trial& trial, Pose& found);

/// The tables: one per pair.
std::string markdown(const std::vector<ScanPair>& pairs, const std::vector<Trial>& trials);

}  // namespace vestige::bench
