// Success of the automatic first pose over random poses of the source, with the registration after it and its
// verdict: bin/auto_table TRIALS SET... (docs/decisions/0008). SET: all, shared (the pairs of shared/data), a
// simulated set by name, or NAME=TARGET,SOURCE,... (tests/bench/auto/Trial.h). Environment: VESTIGE_AUTO_FROM
// the first trial's number, VESTIGE_AUTO_VERBOSE a line for each trial.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <stdexcept>

#include "core/registration/Register.h"
#include "core/registration/global/FirstPose.h"
#include "tests/bench/auto/Trial.h"

namespace vestige::bench {
namespace {

struct Deviation {
    double shift_m = 0;
    double turn_deg = 0;
    bool scale = true;

    bool within(const TrialSet& set) const {
        return scale && shift_m < set.shift_m && turn_deg < set.turn_deg;
    }
};

/// Where most of the source lies; the middle of its bounds may be where nothing is.
Eigen::Vector3d middleOf(const PointCloud& cloud) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < cloud.size(); ++i) sum += cloud.point(i);
    return sum / static_cast<double>(cloud.size());
}

Deviation deviation(const Similarity& found, const Similarity& expected, const PointCloud& source) {
    const Eigen::Vector3d middle = middleOf(source);
    return {(found * middle - expected * middle).norm(),
            degrees(rotationAngle(found.pose.linear().transpose() * expected.pose.linear())),
            std::abs(found.scale / expected.scale - 1) < 1e-6};
}

/// Verdicts by whether the pose is right. A search that finds nothing counts as failed.
struct Tally {
    std::array<int, 4> right{};
    std::array<int, 4> wrong{};
    int named = 0;  ///< ambiguous or failed, but the right pose is among the candidates shown
    std::vector<double> search_s, all_s;
};

/// Seconds of the clock and of the processor since `begin`.
struct Stopwatch {
    std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
    std::clock_t spent = std::clock();
    double processor() const { return static_cast<double>(std::clock() - spent) / CLOCKS_PER_SEC; }
};

void print(const TrialSet& set, std::uint64_t number, const FirstPose& first,
           const RegistrationResult& result, const Trial& trial, double search_s, double all_s) {
    const PointCloud& source = trial.source.vertices;
    const Deviation a = deviation(first.targetFromSource, trial.targetFromSource, source);
    const Deviation b = deviation(result.targetFromSource, trial.targetFromSource, source);
    std::printf("%s %d: %s %s, first %.3f m %.2f deg, registered %.3f m %.2f deg, %.2f s, %.2f s\n",
                set.name.c_str(), static_cast<int>(number), b.within(set) ? "right" : "WRONG",
                std::string(describe(result.verdict)).c_str(), a.shift_m, a.turn_deg, b.shift_m, b.turn_deg,
                search_s, all_s);
    for (const std::string& reason : result.reasons) std::printf("    %s\n", reason.c_str());
    for (std::size_t i = 0; i < first.candidates.size(); ++i) {
        const Deviation d = deviation(first.candidates[i].targetFromSource, trial.targetFromSource, source);
        std::printf("    - %.3f m %.1f deg, %s\n", d.shift_m, d.turn_deg,
                    i < first.notes.size()
                        ? first.notes[first.notes.size() - first.candidates.size() + i].c_str()
                        : "");
    }
    std::fflush(stdout);
}

void runTrial(const TrialSet& set, std::uint64_t number, Tally& tally) {
    const Trial trial = set.trial(number);
    const bool verbose = std::getenv("VESTIGE_AUTO_VERBOSE") != nullptr;
    const Stopwatch watch;
    ParameterSet parameters(registrationParameters());
    std::optional<double> unit;
    if (trial.unit) unit = metresPer(*trial.unit);
    const auto found = findFirstPose(*trial.target, trial.source, unit, parameters);
    tally.search_s.push_back(watch.processor());
    const auto failed = [&](const Error& error) {
        ++tally.wrong[static_cast<std::size_t>(Verdict::failed)];
        tally.all_s.push_back(watch.processor());
        if (verbose)
            std::printf("%s %d: %s\n", set.name.c_str(), static_cast<int>(number), error.sentence().c_str());
    };
    if (!found) return failed(found.error());
    if (found->error_m) (void)parameters.set("start_error_m", *found->error_m);
    auto result = attemptRegistration(*trial.target, trial.source, found->targetFromSource, parameters);
    if (!result) return failed(result.error());
    addFirstPose(*result, *found);
    tally.all_s.push_back(watch.processor());
    const PointCloud& source = trial.source.vertices;
    const bool right =
        trial.hasPlace && deviation(result->targetFromSource, trial.targetFromSource, source).within(set);
    ++(right ? tally.right : tally.wrong)[static_cast<std::size_t>(result->verdict)];
    if (!result->trustworthy())
        tally.named += std::any_of(found->candidates.begin(), found->candidates.end(), [&](const auto& one) {
            return deviation(one.targetFromSource, trial.targetFromSource, source).within({"", 0.3, 3, {}});
        });
    if (verbose) print(set, number, *found, *result, trial, tally.search_s.back(), tally.all_s.back());
}

double middle(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values.empty() ? 0 : values[values.size() / 2];
}

void measure(const TrialSet& set, std::uint64_t from, std::uint64_t trials) {
    Tally tally;
    for (std::uint64_t number = from; number < from + trials; ++number) runTrial(set, number, tally);
    const auto of = [](const std::array<int, 4>& counts, Verdict verdict) {
        return counts[static_cast<std::size_t>(verdict)];
    };
    const auto& r = tally.right;
    const auto& w = tally.wrong;
    std::printf("| %s | %d | %d | %d, %d, %d, %d | %d, %d, %d, %d | %d | %.2f | %.2f | %.2f |\n",
                set.name.c_str(), static_cast<int>(trials), r[0] + r[1] + r[2] + r[3],
                of(r, Verdict::accepted), of(r, Verdict::doubtful), of(r, Verdict::ambiguous),
                of(r, Verdict::failed), of(w, Verdict::accepted), of(w, Verdict::doubtful),
                of(w, Verdict::ambiguous), of(w, Verdict::failed), tally.named, middle(tally.search_s),
                middle(tally.all_s), *std::max_element(tally.all_s.begin(), tally.all_s.end()));
    std::fflush(stdout);
}

/// The sets that a word of the command line asks for.
std::vector<TrialSet> setsOf(const std::string& word) {
    std::vector<TrialSet> sets;
    const auto append = [&](const std::vector<TrialSet>& more) {
        sets.insert(sets.end(), more.begin(), more.end());
    };
    if (word == "shared" || word == "all")
        for (const std::string& pair : sharedPairs()) sets.push_back(setOfFiles(pair));
    if (word == "all") {
        for (const std::string& name : simulatedSets()) append(setsOf(name));
        for (const std::string& name : carSets()) append(setsOf(name));
    }
    if (word.find('=') != std::string::npos) sets.push_back(setOfFiles(word));
    if (auto set = simulatedSet(word)) sets.push_back(*set);
    if (auto set = carSet(word)) sets.push_back(*set);
    for (const std::string& pair : sharedPairs())
        if (pair.starts_with(word + "=")) sets.push_back(setOfFiles(pair));
    if (sets.empty()) throw std::runtime_error("there is no set " + word);
    return sets;
}

}  // namespace
}  // namespace vestige::bench

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fprintf(stderr, "auto_table TRIALS SET...\n");
        return 2;
    }
    const char* from = std::getenv("VESTIGE_AUTO_FROM");
    std::printf("Verdicts: accepted, doubtful, ambiguous, failed. Seconds of the processor.\n\n");
    std::printf(
        "| set | trials | right | right: verdicts | wrong: verdicts | refused, but named | search s | all s "
        "| worst s |\n");
    std::printf("|---|---|---|---|---|---|---|---|---|\n");
    std::fflush(stdout);
    try {
        for (int i = 2; i < argc; ++i)
            for (const vestige::bench::TrialSet& set : vestige::bench::setsOf(argv[i]))
                vestige::bench::measure(set, from ? std::strtoull(from, nullptr, 10) : 0,
                                        std::strtoull(argv[1], nullptr, 10));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
