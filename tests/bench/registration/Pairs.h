#pragma once

#include <string>
#include <vector>

#include "core/geometry/PointCloud.h"
#include "core/geometry/Pose.h"
#include "tests/bench/registration/Scores.h"

namespace vestige::bench {

/// Two clouds to be registered, in metres round the origin zero, with the pose to be found.
struct ScanPair {
    std::string name;
    std::string truth;  ///< where the reference comes from, for the table
    PointCloud target;
    PointCloud source;
    Pose start = Pose::Identity();
    Pose reference = Pose::Identity();
    PoseError referenceError;  ///< how good the reference is; zero for exact truth
};

/// The names known: street, room, apartment, car (real, where shared/data is present), tripod-60k, tripod-1M.
const std::vector<std::string>& pairNames();

/// A pair of files: "TARGET,SOURCE,REFERENCE[,START]", the poses as 4x4 matrices in text; without START the
/// first pose is wrong by 0.5 m and 4 degrees. Throws with a sentence.
ScanPair pairOfFiles(const std::string& files);

/// The pairs asked for; a line to stderr for each that is not on this machine.
std::vector<ScanPair> loadPairs(const std::vector<std::string>& names);

}  // namespace vestige::bench
