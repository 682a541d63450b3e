// Verdicts over right and wrong poses of real scans, run by hand: bin/real_verdicts
// [NAME=TARGET,SOURCE,TRUTH, METRES_PER_UNIT]... adds pairs to those of shared/data. TRUTH: a 4x4 matrix as
// text.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "core/base/Random.h"
#include "core/base/Units.h"
#include "core/io/FormatRegistry.h"
#include "core/registration/Register.h"
#include "tests/support/TestPaths.h"

namespace {

using namespace vestige;

struct Pair {
    std::string name;
    PointCloud target;
    PointCloud source;
    Similarity truth;    ///< to where registration from there is taken to be right
    double far_m = 0.1;  ///< from it: surely another pose
    std::optional<double> startError_m;
};

std::map<std::string, int> rights, wrongs;

PointCloud read(const std::string& file) {
    auto loaded = readGeometry(file);
    if (!loaded) {
        std::fprintf(stderr, "%s\n", loaded.error().sentence().c_str());
        std::exit(1);
    }
    return loaded->geometry.vertices;
}

Pose matrixOf(const std::string& file) {
    std::ifstream stream(file);
    std::array<double, 16> values{};
    for (double& value : values) stream >> value;
    const Result<Pose> pose = poseFromRowMajor(values, 1e-3);
    if (!pose) {
        std::fprintf(stderr, "%s\n", pose.error().sentence().c_str());
        std::exit(1);
    }
    return *pose;
}

Pose poseOf(double x, double y, double z, double yaw_deg) {
    Pose pose = Pose::Identity();
    pose.linear() = Eigen::AngleAxisd(radians(yaw_deg), Eigen::Vector3d::UnitZ()).toRotationMatrix();
    pose.translation() << x, y, z;
    return pose;
}

Pair reversed(const Pair& pair) {
    return {pair.name + " back", pair.source, pair.target, pair.truth.inverse(), pair.far_m, {}};
}

double deviation(const Pair& pair, const Pose& found) {
    const Eigen::Vector3d middle = pair.source.bounds().centre();
    return (found * (pair.truth.scale * middle) - pair.truth * middle).norm() +
           rotationAngle(found.linear().transpose() * pair.truth.pose.linear()) * pair.truth.scale *
               pair.source.bounds().diagonal() / 4;
}

void judgeFrom(const Pair& pair, const Similarity& start, const std::string& what, bool overlaps) {
    ParameterSet parameters(registrationParameters());
    if (pair.startError_m && !parameters.set("start_error_m", *pair.startError_m)) return;
    const auto result = attemptRegistration({pair.target, {}}, {pair.source, {}}, start, parameters);
    if (!result) return;
    const double off = deviation(pair, result->targetFromSource.pose);
    const bool right = overlaps && off < pair.far_m;
    const std::string verdict(describe(result->verdict));
    ++(right ? rights : wrongs)[verdict];
    std::printf(
        "%s %s %s (%.3f m, %.2f deg): %s: %s\n", right ? "right" : "WRONG", pair.name.c_str(), what.c_str(),
        off,
        degrees(rotationAngle(result->targetFromSource.pose.linear().transpose() * pair.truth.pose.linear())),
        verdict.c_str(), result->reasons.front().c_str());
    std::fflush(stdout);
}

void tell(const char* title, const std::map<std::string, int>& verdicts) {
    std::printf("%s:", title);
    for (const auto& [verdict, times] : verdicts) std::printf(" %s %d", verdict.c_str(), times);
    std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
    const std::string what = argc > 1 ? argv[1] : "all";
    std::vector<Pair> pairs;
    const auto add = [&](const char* name, const char* target, const char* source, const Pose& truth,
                         double far_m) {
        const auto one = test::sharedFile(std::string("registration/") + target);
        const auto two = test::sharedFile(std::string("registration/") + source);
        if (!one || !two) return;
        Pair pair{name, read(*one), read(*two), {truth, 1}, far_m, {}};
        const auto found = attemptRegistration({pair.target, {}}, {pair.source, {}}, {truth, 1},
                                               ParameterSet(registrationParameters()));
        if (found) pair.truth = found->targetFromSource;
        pair.far_m = 0.3;
        pairs.push_back(pair);
        pairs.push_back(reversed(pair));
    };
    const auto street = test::sharedFile("registration/street/T_target_source.txt");
    if (street && what != "given")
        add("street", "street/target.ply", "street/source.ply", matrixOf(*street), 0.5);
    Pose room = poseOf(1.79, 0.72, 0, 45.6);
    if (what != "given") add("room", "room/room_scan1.pcd", "room/room_scan2.pcd", room, 1.0);
    if (what != "given")
        add("apartment", "apartment/cloud_0.vtk", "apartment/cloud_1.vtk", poseOf(0.61, -0.01, 0.01, 6.6),
            0.3);
    if (what != "given") add("car", "car/car_cloud400.csv", "car/car_cloud401.csv", Pose::Identity(), 1.5);
    for (int i = 2; i < argc; ++i) {
        const std::string text = argv[i];
        std::stringstream stream(text.substr(text.find('=') + 1));
        std::vector<std::string> parts;
        for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
        const Pair pair{text.substr(0, text.find('=')),
                        read(parts[0]),
                        read(parts[1]),
                        {matrixOf(parts[2]), std::stod(parts[3])},
                        0.1,
                        parts.size() > 4 ? std::optional(std::stod(parts[4])) : std::nullopt};
        pairs.push_back(pair);
    }
    for (const Pair& pair : pairs) {
        if (what == "right" || what == "given" || what == "all") judgeFrom(pair, pair.truth, "right", true);
        if (what == "wrong" || what == "all") {
            if (pair.name.ends_with("back")) continue;
            const Eigen::Vector3d middle = pair.truth * pair.source.bounds().centre();
            const double step = std::max(0.3, pair.truth.scale * pair.source.bounds().diagonal() / 20);
            for (const auto& [x, y, yaw] : std::vector<std::array<double, 3>>{{1, 0, 0},
                                                                              {-1, 0, 0},
                                                                              {0, 1, 0},
                                                                              {0, -1, 0},
                                                                              {3, 0, 0},
                                                                              {-3, 0, 0},
                                                                              {0, 3, 0},
                                                                              {0, -3, 0},
                                                                              {0, 0, 90},
                                                                              {0, 0, 180},
                                                                              {0, 0, 270},
                                                                              {2, 1, 180},
                                                                              {-2, -1, 180}}) {
                const Pose move = Eigen::Translation3d(middle) * poseOf(x * step, y * step, 0, yaw) *
                                  Eigen::Translation3d(-middle);
                Similarity start = pair.truth;
                start.pose = move * pair.truth.pose;
                judgeFrom(pair, start,
                          "from " + std::to_string(x * step) + " " + std::to_string(y * step) + " " +
                              std::to_string(yaw),
                          true);
            }
            for (const Pair& other : pairs) {
                if (other.name.starts_with(pair.name) || other.truth.scale != pair.truth.scale) continue;
                Pair mixed{pair.name + " with " + other.name, pair.target, other.source, {}, 0, {}};
                mixed.truth.scale = other.truth.scale;
                Similarity start{poseOf(0, 0, 0, 0), other.truth.scale};
                start.pose.translation() =
                    pair.target.bounds().centre() - other.truth.scale * other.source.bounds().centre();
                judgeFrom(mixed, start, "other scene", false);
            }
        }
    }
    tell("right", rights);
    tell("wrong", wrongs);
    return 0;
}
