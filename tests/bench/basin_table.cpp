// How far off a first pose may be: the table of docs/benchmarks.md. By hand: ninja basin_table &&
// bin/basin_table SHARED_DATA [starts] [pair ...]; each row also has the error and the time of the pair's own
// first pose. Success: under 0.1 m and 1 degree from the reference, at the source's origin.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <string>

#include "core/base/Parallel.h"
#include "core/base/Units.h"
#include "core/io/FormatRegistry.h"
#include "core/registration/FindPose.h"
#include "core/registration/Register.h"
#include "core/simulation/TripodPair.h"

namespace {

using namespace vestige;

struct Pair {
    std::string name;
    PointCloud target, source;
    Pose start = Pose::Identity();
    Pose reference = Pose::Identity();
};

PointCloud read(const std::filesystem::path& file) {
    Result<LoadedGeometry> loaded = readGeometry(file);
    if (!loaded) {
        std::fprintf(stderr, "%s\n", loaded.error().sentence().c_str());
        std::exit(3);
    }
    return std::move(loaded->geometry.vertices);
}

Pose turned(double degrees, double x, double y, double z) {
    Pose pose = Pose::Identity();
    pose.linear() = Eigen::AngleAxisd(radians(degrees), Eigen::Vector3d::UnitZ()).toRotationMatrix();
    pose.translation() << x, y, z;
    return pose;
}

Pair street(const std::filesystem::path& shared) {
    Pair pair{"street", read(shared / "registration/street/target.ply"),
              read(shared / "registration/street/source.ply")};
    std::ifstream file(shared / "registration/street/T_target_source.txt");
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column) file >> pair.reference.matrix()(row, column);
    return pair;
}

Pair apartment(const std::filesystem::path& shared) {
    return {"apartment", read(shared / "registration/apartment/cloud_0.vtk"),
            read(shared / "registration/apartment/cloud_1.vtk"), Pose::Identity(),
            turned(6.6, 0.611, -0.009, 0.008)};
}

/// Its reference is what our own registration says from the tutorial's first pose.
Pair room(const std::filesystem::path& shared) {
    Pair pair{"room", read(shared / "registration/room/room_scan1.pcd"),
              read(shared / "registration/room/room_scan2.pcd"), turned(45.6, 1.79, 0.72, 0)};
    const auto found =
        findPose(pair.target, pair.source, {pair.start, 1}, ParameterSet(registrationParameters()));
    if (found) pair.reference = found->targetFromSource.pose;
    return pair;
}

Pair simulated(const std::string& name, std::size_t points, std::uint64_t seed) {
    TripodPairOptions options;
    options.points = points;
    options.seed = seed;
    options.scene.seed = seed;
    TripodPair made = simulateTripodPair(options);
    Pair pair{name, std::move(made.target), std::move(made.source)};
    pair.reference = made.targetFromSource();
    pair.start = wrongPose(pair.reference, 0.5, 4, 17);
    return pair;
}

struct Trial {
    double metres = 1e9, degrees = 1e9, milliseconds = 0;
    RegistrationResult result;
};

Trial tried(const Pair& pair, const Pose& start, const ParameterSet& parameters) {
    Trial trial;
    const auto begin = std::chrono::steady_clock::now();
    auto found = findPose(pair.target, pair.source, {start, 1}, parameters);
    trial.milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    if (!found) return trial;
    const Pose& pose = found->targetFromSource.pose;
    trial.metres = (pose.translation() - pair.reference.translation()).norm();
    trial.degrees = degrees(rotationAngle(pair.reference.linear().transpose() * pose.linear()));
    trial.result = std::move(*found);
    return trial;
}

void row(const Pair& pair, int starts, const ParameterSet& parameters) {
    std::vector<double> times;
    Trial own;
    for (int round = 0; round < (std::getenv("ROUNDS") ? std::atoi(std::getenv("ROUNDS")) : 7); ++round) {
        own = tried(pair, pair.start, parameters);
        times.push_back(own.milliseconds);
    }
    std::sort(times.begin(), times.end());
    std::printf("%-10s %7.2f ms (min %.2f) %7.2f mm %.4f deg, %d iterations, overlap %.3f, levels",
                pair.name.c_str(), times[times.size() / 2], times.front(), 1000 * own.metres, own.degrees,
                own.result.iterations, own.result.overlap);
    for (const RegistrationLevel& level : own.result.levels)
        std::printf(" %.3g/%d", level.voxel_m, level.iterations);
    std::printf("\n");
    const bool verbose = std::getenv("VERBOSE") != nullptr;
    for (const auto& [metres, angle] : {std::pair{1.0, 10.0}, {2.0, 20.0}, {5.0, 45.0}}) {
        int reached = 0;
        double total = 0;
        for (int i = 0; i < starts; ++i) {
            const Trial trial =
                tried(pair, wrongPose(pair.reference, metres, angle, static_cast<std::uint64_t>(i) + 1),
                      parameters);
            const bool good = trial.metres < 0.1 && trial.degrees < 1;
            reached += good;
            total += trial.milliseconds;
            if (verbose)
                std::printf("  %d %s %.2f m %.1f deg overlap %.3f score %.4f\n", i, good ? "ok  " : "LOST",
                            trial.metres, trial.degrees, trial.result.overlap,
                            trial.result.levels.empty() ? 0 : trial.result.levels.back().score);
        }
        if (starts > 0)
            std::printf("  %g m / %g deg: %d of %d, %.1f ms each\n", metres, angle, reached, starts,
                        total / starts);
    }
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "basin_table SHARED_DATA [starts] [pair ...] [name=value ...]\n");
        return 2;
    }
    const std::filesystem::path shared = argv[1];
    const int starts = argc > 2 ? std::atoi(argv[2]) : 50;
    ParameterSet parameters(registrationParameters());
    std::vector<std::string> wanted;
    for (int i = 3; i < argc; ++i) {
        const std::string text = argv[i];
        const auto equals = text.find('=');
        if (equals == std::string::npos) {
            wanted.push_back(text);
        } else if (text.substr(0, equals) == "threads") {
            setThreadCount(std::atoi(text.c_str() + equals + 1));
        } else {
            const std::string value = text.substr(equals + 1);
            const bool number = value.find_first_not_of("0123456789.e-") == std::string::npos;
            const auto set = number ? parameters.set(text.substr(0, equals), std::stod(value))
                                    : parameters.set(text.substr(0, equals), value);
            if (!set) std::fprintf(stderr, "%s\n", set.error().sentence().c_str());
        }
    }
    const std::vector<std::pair<std::string, std::function<Pair()>>> pairs{
        {"street", [&] { return street(shared); }},
        {"apartment", [&] { return apartment(shared); }},
        {"room", [&] { return room(shared); }},
        {"tripod60k", [] { return simulated("tripod60k", 60000, 1); }},
        {"tripod60k2", [] { return simulated("tripod60k2", 60000, 2); }},
        {"tripod1M", [] { return simulated("tripod1M", 1000000, 1); }}};
    for (const auto& [name, make] : pairs)
        if (wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end())
            row(make(), starts, parameters);
    return 0;
}
