#include "tests/bench/registration/Pairs.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "core/base/Units.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/io/FormatRegistry.h"
#include "core/simulation/TripodPair.h"
#include "tests/bench/registration/AskPeer.h"
#include "tests/support/TestPaths.h"

namespace vestige::bench {
namespace {

/// The wrong first pose of the simulated pairs.
constexpr double kStartDistance_m = 0.5;
constexpr double kStartAngle_deg = 4;

PointCloud readCloud(const std::filesystem::path& file) {
    Result<LoadedGeometry> loaded = readGeometry(file);
    if (!loaded) throw std::runtime_error(loaded.error().sentence());
    // In the file's own frame, as a peer's reader would have it: where a grid begins changes what NDT finds.
    PointCloudBuilder builder{Eigen::Vector3d::Zero()};
    const PointCloud& cloud = loaded->geometry.vertices;
    for (std::size_t i = 0; i < cloud.size(); ++i) builder.add(cloud.point(i));
    return std::move(builder).build();
}

Pose readMatrix(const std::filesystem::path& file) {
    std::ifstream stream(file);
    std::array<double, 16> values{};
    for (double& value : values) stream >> value;
    const Result<Pose> pose = poseFromRowMajor(values, 1e-3);
    if (!pose) throw std::runtime_error(pose.error().sentence());
    return *pose;
}

/// GICP with ever finer voxels, from the start: biased towards GICP, good to some millimetres.
Pose fineGicp(const ScanPair& pair) {
    return askPeer(vestige_peer_pcl_avx2, PeerMethod::reference, pair, 0, 1);
}

struct RealPair {
    const char* name;
    const char* target;
    const char* source;
};
constexpr std::array<RealPair, 4> kReal{{{"street", "street/target.ply", "street/source.ply"},
                                         {"room", "room/room_scan1.pcd", "room/room_scan2.pcd"},
                                         {"apartment", "apartment/cloud_0.vtk", "apartment/cloud_1.vtk"},
                                         {"car", "car/car_cloud400.csv", "car/car_cloud401.csv"}}};

std::optional<ScanPair> readPair(const RealPair& files) {
    const auto target = test::sharedFile(std::string("registration/") + files.target);
    const auto source = test::sharedFile(std::string("registration/") + files.source);
    const auto matrix = test::sharedFile("registration/street/T_target_source.txt");
    const std::string name = files.name;
    if (!target || !source || (name == "street" && !matrix)) return std::nullopt;
    ScanPair pair;
    pair.name = name;
    pair.target = readCloud(*target);
    pair.source = readCloud(*source);
    if (name == "street") {
        pair.truth = "its own reference, good to 2 cm and 0.7 degrees";
        pair.reference = readMatrix(*matrix);
        pair.referenceError = {0.02, radians(0.7)};
        return pair;
    }
    if (name == "room") {
        // The start of the tutorial that the pair comes from.
        pair.start.linear() = Eigen::AngleAxisd(radians(45.6), Eigen::Vector3d::UnitZ()).toRotationMatrix();
        pair.start.translation() << 1.79, 0.72, 0;
    }
    pair.reference = fineGicp(pair);
    pair.truth = "GICP down to 0.03 m, good to 5 mm and 0.2 degrees";
    pair.referenceError = {0.005, radians(0.2)};
    if (name == "car") {
        // Two such chains from different starts end this far apart.
        pair.truth = "GICP down to 0.03 m, good to 4 cm and 0.5 degrees";
        pair.referenceError = {0.04, radians(0.5)};
    }
    if (name == "apartment") {
        const Eigen::Vector3d published(0.6083, -0.0039, 0.0107);
        std::fprintf(stderr, "apartment: GICP ends %.0f mm from the published place\n",
                     1000 * (pair.reference.translation() - published).norm());
        pair.referenceError = {0.02, radians(0.3)};
        pair.truth = "GICP down to 0.03 m, good to 2 cm and 0.3 degrees";
    }
    return pair;
}

ScanPair tripodPair(const std::string& name, std::size_t points) {
    TripodPairOptions options;
    options.points = points;
    const TripodPair simulated = simulateTripodPair(options);
    const Pose truth = simulated.targetFromSource();
    return {name,
            "exact",
            simulated.target,
            simulated.source,
            wrongPose(truth, kStartDistance_m, kStartAngle_deg, 1),
            truth,
            {}};
}

}  // namespace

const std::vector<std::string>& pairNames() {
    static const std::vector<std::string> names{"street", "room",       "apartment",
                                                "car",    "tripod-60k", "tripod-1M"};
    return names;
}

ScanPair pairOfFiles(const std::string& files) {
    std::vector<std::string> parts;
    std::stringstream stream(files);
    for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
    if (parts.size() < 3) throw std::runtime_error("--pair=TARGET,SOURCE,REFERENCE[,START] was expected");
    ScanPair pair;
    pair.name = std::filesystem::path(parts[0]).stem().string() + " - " +
                std::filesystem::path(parts[1]).stem().string();
    pair.truth = parts[2];
    pair.target = readCloud(parts[0]);
    pair.source = readCloud(parts[1]);
    pair.reference = readMatrix(parts[2]);
    pair.start = parts.size() > 3 ? readMatrix(parts[3])
                                  : wrongPose(pair.reference, kStartDistance_m, kStartAngle_deg, 1);
    return pair;
}

std::vector<ScanPair> loadPairs(const std::vector<std::string>& names) {
    std::vector<ScanPair> pairs;
    for (const std::string& name : names) {
        std::optional<ScanPair> pair;
        if (name == "tripod-60k") pair = tripodPair(name, 60000);
        if (name == "tripod-1M") pair = tripodPair(name, 1000000);
        for (const RealPair& files : kReal)
            if (name == files.name) pair = readPair(files);
        if (pair)
            pairs.push_back(std::move(*pair));
        else
            std::fprintf(stderr, "%s: skipped, not on this machine\n", name.c_str());
    }
    return pairs;
}

}  // namespace vestige::bench
