// Success of the automatic first pose over random poses of the source, pair by pair, against truth or the
// pose reached from picked pairs: bin/auto_table TRIALS
// [NAME=TARGET,SOURCE,TRUTH,METRES_PER_UNIT,SHIFT_M,TURN_DEG[,SIDE_M,POINTS]]... TRUTH: a 4x4 matrix as text,
// picks.csv, or a pose file (.json). SIDE_M crops the target to a square round the source's place, POINTS
// thins it by taking every k-th. Verbose with VESTIGE_AUTO_VERBOSE set.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <sstream>

#include "core/base/Random.h"
#include "core/base/Units.h"
#include "core/io/FormatRegistry.h"
#include "core/registration/InitialPose.h"
#include "core/registration/Register.h"
#include "core/registration/global/FirstPose.h"

namespace {

using namespace vestige;

struct Pair {
    std::string name;
    PointCloud target;
    PointCloud source;
    Similarity truth;
    double shift_m = 0;
    double turn_deg = 0;
};

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::stringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
    return parts;
}

[[noreturn]] void stop(const std::string& why) {
    std::fprintf(stderr, "%s\n", why.c_str());
    std::exit(1);
}

PointCloud readCloud(const std::string& file) {
    auto loaded = readGeometry(file);
    if (!loaded) stop(loaded.error().sentence());
    return loaded->geometry.vertices;
}

/// What picked pairs lead to, or what the file says.
Similarity truthOf(const std::string& file, double scale, const PointCloud& target,
                   const PointCloud& source) {
    if (file.ends_with(".json")) {
        const auto pose = readPoseFile(file);
        if (!pose) stop(pose.error().sentence());
        return *pose;
    }
    if (file.ends_with(".csv")) {
        const auto pairs = readPointPairs(file);
        if (!pairs) stop(pairs.error().sentence());
        const auto start = alignPairs(*pairs, scale);
        if (!start) stop(start.error().sentence());
        const auto result = attemptRegistration({target, {}}, {source, {}}, start->targetFromSource,
                                                ParameterSet(registrationParameters()));
        if (!result) stop(result.error().sentence());
        return result->targetFromSource;
    }
    std::array<double, 16> values{};
    std::ifstream stream(file);
    for (double& value : values) stream >> value;
    const auto pose = poseFromRowMajor(values, 1e-3);
    if (!pose) stop(pose.error().sentence());
    return {*pose, scale};
}

PointCloud cropped(const PointCloud& cloud, const Eigen::Vector3d& middle, double side_m,
                   std::size_t points) {
    std::vector<std::uint32_t> inside;
    for (std::uint32_t i = 0; i < cloud.size(); ++i)
        if ((cloud.point(i) - middle).head<2>().cwiseAbs().maxCoeff() < side_m / 2) inside.push_back(i);
    std::vector<std::uint32_t> kept;
    for (std::size_t k = 0; k < std::min(points, inside.size()); ++k)
        kept.push_back(inside[k * inside.size() / std::min(points, inside.size())]);
    return cloud.select(kept);
}

Pair readPair(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) stop("expected NAME=TARGET,SOURCE,...: " + text);
    const std::vector<std::string> parts = split(text.substr(equals + 1), ',');
    if (parts.size() != 6 && parts.size() != 8) stop("expected six or eight parts: " + text);
    Pair pair{text.substr(0, equals), readCloud(parts[0]), readCloud(parts[1]), {}, 0, 0};
    pair.truth = truthOf(parts[2], std::stod(parts[3]), pair.target, pair.source);
    pair.shift_m = std::stod(parts[4]);
    pair.turn_deg = std::stod(parts[5]);
    if (parts.size() == 8)
        pair.target = cropped(pair.target, pair.truth * pair.source.bounds().centre(), std::stod(parts[6]),
                              std::stoul(parts[7]));
    return pair;
}

Pose randomPose(std::uint64_t trial, double reach) {
    Random random(7, trial);
    Eigen::Quaterniond turn;
    turn.coeffs() << random.normal(), random.normal(), random.normal(), random.normal();
    Pose pose = Pose::Identity();
    pose.linear() = turn.normalized().toRotationMatrix();
    for (int axis = 0; axis < 3; ++axis) pose.translation()[axis] = random.uniform(-reach, reach);
    return pose;
}

struct Deviation {
    double shift_m = 0;
    double turn_deg = 0;
};

Deviation deviation(const Similarity& found, const Similarity& expected, const Eigen::Vector3d& middle) {
    return {(found * middle - expected * middle).norm(),
            degrees(rotationAngle(found.pose.linear().transpose() * expected.pose.linear()))};
}

void measure(const Pair& pair, int trials) {
    int placed = 0;
    int right = 0;
    int ambiguous = 0;
    int wrong = 0;
    double processor = 0;
    std::vector<double> search, total;
    const bool verbose = std::getenv("VESTIGE_AUTO_VERBOSE") != nullptr;
    for (int trial = 0; trial < trials; ++trial) {
        const Similarity away{
            randomPose(static_cast<std::uint64_t>(trial), 2 * pair.source.bounds().diagonal()), 1};
        const PointCloud moved = pair.source.transformed(away);
        Similarity expected = pair.truth;
        expected.pose = pair.truth.pose;
        expected = expected * away.inverse();
        const Eigen::Vector3d middle = away * pair.source.bounds().centre();
        ParameterSet parameters(registrationParameters());
        const auto begin = std::chrono::steady_clock::now();
        const std::clock_t spent = std::clock();
        const auto seconds = [&] {
            return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        };
        const auto found = findFirstPose({pair.target, {}}, {moved, {}}, {}, parameters);
        search.push_back(seconds());
        processor += static_cast<double>(std::clock() - spent) / CLOCKS_PER_SEC;
        if (!found) {
            if (verbose)
                std::printf("%s %d: %s\n", pair.name.c_str(), trial, found.error().sentence().c_str());
            total.push_back(seconds());
            ++wrong;
            continue;
        }
        if (found->error_m) (void)parameters.set("start_error_m", *found->error_m);
        auto result =
            attemptRegistration({pair.target, {}}, {moved, {}}, found->targetFromSource, parameters);
        total.push_back(seconds());
        if (!result) {
            ++wrong;
            continue;
        }
        addFirstPose(*result, *found);
        const Deviation first = deviation(found->targetFromSource, expected, middle);
        const Deviation last = deviation(result->targetFromSource, expected, middle);
        const bool good = result->targetFromSource.scale == expected.scale && last.shift_m < pair.shift_m &&
                          last.turn_deg < pair.turn_deg;
        placed += good;
        right += good && result->trustworthy();
        ambiguous += result->verdict == Verdict::ambiguous;
        wrong += !good && result->trustworthy();
        if (!verbose) continue;
        std::printf("%s %d: first %.3f m %.2f deg, registered %.3f m %.2f deg, %s, %.2f s, %.2f s in all\n",
                    pair.name.c_str(), trial, first.shift_m, first.turn_deg, last.shift_m, last.turn_deg,
                    std::string(describe(result->verdict)).c_str(), search.back(), total.back());
        for (const std::string& note : result->notes) std::printf("    %s\n", note.c_str());
        for (const PoseCandidate& candidate : found->candidates) {
            const Deviation d = deviation(candidate.targetFromSource, expected, middle);
            std::printf("    %.2f: %.2f m %.1f deg\n", candidate.score, d.shift_m, d.turn_deg);
        }
        std::fflush(stdout);
    }
    std::sort(search.begin(), search.end());
    std::sort(total.begin(), total.end());
    std::printf("| %s | %zu | %zu | %d of %d | %d | %d | %d | %.2f | %.2f | %.2f | %.2f |\n",
                pair.name.c_str(), pair.target.size(), pair.source.size(), placed, trials, right, ambiguous,
                wrong, search[search.size() / 2], processor / trials, total[total.size() / 2], total.back());
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3)
        stop(
            "auto_table TRIALS NAME=TARGET,SOURCE,TRUTH,METRES_PER_UNIT,SHIFT_M,TURN_DEG[,SIDE_M,POINTS]...");
    std::printf(
        "| pair | target | source | right pose | and relied on | ambiguous | wrong | search s | of processor "
        "| all s | worst s "
        "|\n");
    std::printf("|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (int i = 2; i < argc; ++i) measure(readPair(argv[i]), std::atoi(argv[1]));
}
