#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "core/base/Random.h"
#include "core/io/FormatRegistry.h"
#include "core/registration/InitialPose.h"
#include "core/registration/Register.h"
#include "tests/bench/auto/Trial.h"
#include "tests/support/TestPaths.h"

namespace vestige::bench {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::stringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
    return parts;
}

template <class Value>
Value valueOf(Result<Value> result) {
    if (!result) throw std::runtime_error(result.error().sentence());
    return std::move(*result);
}

/// What picked pairs lead to, or what the file says.
Similarity truthOf(const std::string& file, double scale, const TriangleMesh& target,
                   const TriangleMesh& source) {
    if (file.ends_with(".json")) return valueOf(readPoseFile(file));
    if (file.ends_with(".csv")) {
        const auto start = valueOf(alignPairs(valueOf(readPointPairs(file)), scale));
        ParameterSet parameters(registrationParameters());
        (void)parameters.set("restarts", std::int64_t{0});
        return valueOf(attemptRegistration(target, source, start.targetFromSource, parameters))
            .targetFromSource;
    }
    std::array<double, 16> values{};
    std::ifstream stream(file);
    for (double& value : values) stream >> value;
    return {valueOf(poseFromRowMajor(values, 1e-3)), scale};
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

}  // namespace

Pose anyPose(std::uint64_t trial, double reach) {
    Random random(7, trial);
    Eigen::Quaterniond turn;
    turn.coeffs() << random.normal(), random.normal(), random.normal(), random.normal();
    Pose pose = Pose::Identity();
    pose.linear() = turn.normalized().toRotationMatrix();
    for (int axis = 0; axis < 3; ++axis) pose.translation()[axis] = random.uniform(-reach, reach);
    return pose;
}

void moveAway(Trial& trial, std::uint64_t number, double metresPerUnit) {
    const Similarity away{anyPose(number, 2 * trial.source.vertices.bounds().diagonal()), 1};
    const Similarity unit{Pose::Identity(), 1 / metresPerUnit};
    trial.source = {trial.source.vertices.transformed(away).transformed(unit), {}};
    for (Similarity* truth : {&trial.targetFromSource})
        *truth = *truth * away.inverse() * Similarity{Pose::Identity(), metresPerUnit};
    for (Similarity& twin : trial.twins)
        twin = twin * away.inverse() * Similarity{Pose::Identity(), metresPerUnit};
}

TrialSet setOfFiles(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) throw std::runtime_error("expected NAME=TARGET,SOURCE,...: " + text);
    const std::vector<std::string> parts = split(text.substr(equals + 1), ',');
    if (parts.size() != 6 && parts.size() != 8)
        throw std::runtime_error("expected six or eight parts: " + text);
    TriangleMesh target = valueOf(readGeometry(parts[0])).geometry;
    const auto source = std::make_shared<TriangleMesh>(valueOf(readGeometry(parts[1])).geometry);
    const Similarity truth = truthOf(parts[2], std::stod(parts[3]), target, *source);
    if (parts.size() == 8)
        target = {cropped(target.vertices, truth * source->vertices.bounds().centre(), std::stod(parts[6]),
                          std::stoul(parts[7])),
                  {}};
    const auto there = std::make_shared<TriangleMesh>(std::move(target));
    TrialSet set{text.substr(0, equals), std::stod(parts[4]), std::stod(parts[5]), {}};
    set.trial = [there, source, truth](std::uint64_t number) {
        Trial trial{there, *source, truth, {}, true, {}};
        moveAway(trial, number);
        return trial;
    };
    return set;
}

std::vector<std::string> sharedPairs() {
    const auto shared = [](const std::string& name) {
        const auto file = test::sharedFile("registration/" + name);
        return file ? file->string() : std::string();
    };
    const auto picks = [](const std::string& name) {
        return test::dataFile("registration/" + name + "_picks.csv").string();
    };
    std::vector<std::string> texts;
    const auto add = [&](const std::string& name, const std::string& target, const std::string& source,
                         const std::string& truth, const std::string& limits) {
        const std::string there = shared(target);
        const std::string here = shared(source);
        if (!there.empty() && !here.empty() && !truth.empty())
            texts.push_back(name + "=" + there + "," + here + "," + truth + ",1," + limits);
    };
    add("street", "street/target.ply", "street/source.ply", shared("street/T_target_source.txt"), "0.1,1");
    add("apartment", "apartment/cloud_0.vtk", "apartment/cloud_1.vtk",
        test::dataFile("registration/apartment_pose.json").string(), "0.1,1");
    add("room", "room/room_scan1.pcd", "room/room_scan2.pcd", picks("room"), "0.1,1");
    add("car", "car/car_cloud400.csv", "car/car_cloud401.csv", picks("car"), "0.1,1");
    add("dragon", "objects/dragon1.xyz", "objects/dragon2.xyz", picks("dragon"), "0.1,1");
    add("bunny", "objects/bunny_part1.xyz", "objects/bunny_part2.xyz", picks("bunny"), "0.1,1");
    return texts;
}

}  // namespace vestige::bench
