// How wrong a first pose may be: of 50 random first poses, wrong by exactly so many metres and degrees, how
// many end under 0.1 m and 1 degree from the reference.
//
//   bench_basin [--pairs=street,...] [--starts=50] [--only=METHOD]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <sstream>

#include "core/base/Units.h"
#include "core/simulation/TripodPair.h"
#include "tests/bench/registration/Contenders.h"

namespace {

using namespace vestige;
using namespace vestige::bench;

struct Size {
    double metres;
    double degrees;
};
constexpr Size kSizes[] = {{1, 10}, {2, 20}, {5, 45}};
constexpr double kReached_m = 0.1;
constexpr double kReached_deg = 1;

/// The contenders of the table, with the setting they get.
struct Row {
    const char* contender;
    double leaf_m;
};
constexpr Row kRows[] = {{"improved NDT", 0},  {"our NDT", 0},          {"our ICP", 0},
                         {"PCL NDT, AVX2", 1}, {"PCL GICP, AVX2", 0.2}, {"Open3D plane ICP", 0.2}};
/// The pairs that the peers are tried on; the others are only ours, they would take an hour.
constexpr const char* kPeerPairs[] = {"street", "apartment", "tripod-60k"};

struct Outcome {
    int reached = 0;
    double seconds = 0;  ///< of all starts
};

Outcome tryStarts(const ScanPair& pair, const Contender& contender, double leaf, const Size& size,
                  int starts) {
    Outcome outcome;
    ScanPair moved = pair;
    for (int i = 0; i < starts; ++i) {
        moved.start = wrongPose(pair.reference, size.metres, size.degrees, static_cast<std::uint64_t>(i) + 1);
        const auto begin = std::chrono::steady_clock::now();
        const PoseError error = poseError(contender.run(moved, leaf, 1), pair.reference);
        outcome.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        outcome.reached += error.translation_m < kReached_m && degrees(error.rotation_rad) < kReached_deg;
    }
    return outcome;
}

void printRow(const ScanPair& pair, const Contender& contender, double leaf, int starts) {
    std::printf("| %s | %s | ", pair.name.c_str(), contender.name.c_str());
    if (leaf > 0)
        std::printf("%g m |", leaf);
    else
        std::printf("- |");
    for (const Size& size : kSizes) {
        const Outcome outcome = tryStarts(pair, contender, leaf, size, starts);
        std::printf(" %d of %d, %.0f ms |", outcome.reached, starts, 1000 * outcome.seconds / starts);
    }
    std::printf("\n");
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::string> names = pairNames();
    int starts = 50;
    std::string only;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        if (argument.starts_with("--pairs=")) {
            names.clear();
            std::stringstream stream(argument.substr(8));
            for (std::string name; std::getline(stream, name, ',');) names.push_back(name);
        } else if (argument.starts_with("--starts=")) {
            starts = std::max(1, std::atoi(argument.c_str() + 9));
        } else if (argument.starts_with("--only=")) {
            only = argument.substr(7);
        } else {
            std::fprintf(stderr, "unknown argument %s\n", argument.c_str());
            return 2;
        }
    }
    std::printf("| pair | method | setting |");
    for (const Size& size : kSizes) std::printf(" %g m / %g degrees |", size.metres, size.degrees);
    std::printf("\n|---|---|---|---|---|---|\n");
    for (const ScanPair& pair : loadPairs(names)) {
        const bool peers =
            std::find(std::begin(kPeerPairs), std::end(kPeerPairs), pair.name) != std::end(kPeerPairs);
        for (const Row& row : kRows) {
            for (const Contender& contender : contenders(false)) {
                if (contender.name != row.contender) continue;
                if (!only.empty() && contender.name != only) continue;
                if (!peers && contender.name != kRows[0].contender) continue;
                printRow(pair, contender, row.leaf_m, starts);
            }
        }
    }
    return 0;
}
