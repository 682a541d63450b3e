// How accurate registration is over many simulated accidents: other scenes, other stations, other wrong first
// poses, exact truth.
//
//   bench_accuracy [--seeds=30] [--points=60000] [--only=METHOD]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/base/Units.h"
#include "core/simulation/TripodPair.h"
#include "tests/bench/registration/Contenders.h"

namespace {

using namespace vestige;
using namespace vestige::bench;

/// The contenders of the table, with the setting they get.
struct Row {
    const char* contender;
    double leaf_m;
};
constexpr Row kRows[] = {{"improved NDT", 0},  {"our NDT", 0},          {"our ICP", 0},
                         {"PCL NDT, AVX2", 1}, {"PCL GICP, AVX2", 0.2}, {"Open3D plane ICP", 0.4}};

ScanPair accident(std::uint64_t seed, std::size_t points) {
    TripodPairOptions options;
    options.scene.seed = seed;
    options.seed = seed;
    options.points = points;
    const TripodPair simulated = simulateTripodPair(options);
    const Pose truth = simulated.targetFromSource();
    return {"accident", "exact", simulated.target, simulated.source, wrongPose(truth, 0.5, 4, seed),
            truth,      {}};
}

void printRow(const char* name, const std::vector<PoseError>& errors) {
    std::vector<double> metres;
    std::vector<double> angles;
    for (const PoseError& error : errors) {
        metres.push_back(1000 * error.translation_m);
        angles.push_back(degrees(error.rotation_rad));
    }
    const auto lost = std::count_if(errors.begin(), errors.end(), missed);
    std::printf("| %s | %.2f | %.2f | %.4f | %.4f | %ld of %zu |\n", name, median(metres),
                *std::max_element(metres.begin(), metres.end()), median(angles),
                *std::max_element(angles.begin(), angles.end()), static_cast<long>(lost), errors.size());
}

}  // namespace

int main(int argc, char** argv) {
    int seeds = 30;
    std::size_t points = 60000;
    std::string only;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        const std::string value = argument.substr(std::min(argument.size(), argument.find('=') + 1));
        if (argument.starts_with("--seeds=")) {
            seeds = std::max(1, std::atoi(value.c_str()));
        } else if (argument.starts_with("--points=")) {
            points = static_cast<std::size_t>(std::max(1000L, std::atol(value.c_str())));
        } else if (argument.starts_with("--only=")) {
            only = value;
        } else {
            std::fprintf(stderr, "unknown argument %s\n", argument.c_str());
            return 2;
        }
    }
    std::vector<std::vector<PoseError>> errors(std::size(kRows));
    for (int seed = 1; seed <= seeds; ++seed) {
        const ScanPair pair = accident(static_cast<std::uint64_t>(seed), points);
        for (const Contender& contender : contenders(false)) {
            for (std::size_t row = 0; row < std::size(kRows); ++row) {
                if (contender.name != kRows[row].contender) continue;
                if (!only.empty() && contender.name != only) continue;
                errors[row].push_back(poseError(contender.run(pair, kRows[row].leaf_m, 2), pair.reference));
                if (!only.empty())
                    std::fprintf(stderr, "seed %d: %.2f mm, %.4f deg\n", seed,
                                 1000 * errors[row].back().translation_m,
                                 degrees(errors[row].back().rotation_rad));
            }
        }
    }
    std::printf(
        "| method, %zu points | median mm | largest mm | median deg | largest deg | missed by 0.1 m |\n"
        "|---|---|---|---|---|---|\n",
        points);
    for (std::size_t row = 0; row < std::size(kRows); ++row)
        if (!errors[row].empty()) printRow(kRows[row].contender, errors[row]);
    return 0;
}
