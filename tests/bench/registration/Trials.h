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

/// How many times the time of ours a trial takes: the median of the rounds' ratios ("> " where it missed the
/// pose), and by least processor time. "-" where one was not measured.
std::string wallRatio(const Trial& trial, const std::vector<Trial>& trials);
std::string cpuRatio(const Trial& trial, const std::vector<Trial>& trials);
/// Ours with the same pair and number of threads.
const Trial* oursFor(const Trial& trial, const std::vector<Trial>& trials);

/// One row per pair with what is to be reached.
std::string goalsTable(const std::vector<ScanPair>& pairs, const std::vector<Trial>& trials);
/// The tables: what is to be reached, then one per pair.
std::string markdown(const std::vector<ScanPair>& pairs, const std::vector<Trial>& trials);

}  // namespace vestige::bench
