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
    int repetitions = 1;  ///< in a round; more for what takes little time
    RoundTimes seconds;   ///< [round][repetition]; a round that was refused has none

    bool refused(std::size_t round) const { return seconds[round].empty(); }
};

/// Runs every contender once at each of its settings, and picks those that the rounds measure.
std::vector<Trial> survey(const std::vector<ScanPair>& pairs, const std::vector<int>& threads, int rounds);

/// One run, in seconds; `found` is what it found.
double timedRun(const Trial& trial, Pose& found);

/// The tables: one per pair.
std::string markdown(const std::vector<ScanPair>& pairs, const std::vector<Trial>& trials);

}  // namespace vestige::bench
