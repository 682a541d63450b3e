#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/bench/registration/Pairs.h"

namespace vestige::bench {

/// A method that registers a pair from the points in memory; everything it does with them is timed.
struct Contender {
    std::string name;
    bool ours = false;
    std::vector<int> threads{1};
    std::vector<double> leaves_m;  ///< the settings to try; one 0 for none to choose
    double asked_m = 0;            ///< a setting that is always shown; 0 for none
    std::function<Pose(const ScanPair&, double leaf_m, int threads)> run;
};

/// The first is what the others are compared with. `large`: fewer settings, for clouds of a million points.
std::vector<Contender> contenders(bool large);

}  // namespace vestige::bench
