#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/geometry/Pose.h"

namespace vestige {

struct PeerOptions {
    double voxel_m = 1;                  ///< NDT: edge of a cell; ICP: largest distance of a pair
    std::optional<double> outlierRatio;  ///< NDT: nothing means the library's own
    int iterationLimit = 50;
};

struct PeerOutcome {
    Pose targetFromSource = Pose::Identity();
    bool converged = false;
    int iterations = 0;
};

/// PCL's classic NDT (Magnusson 2009): one voxel size, Newton with More-Thuente line search. Its epsilon is
/// compared with the squared step; 1e-4 is used, since the customary 0.01 stops after one iteration.
PeerOutcome alignWithPclNdt(const std::vector<Eigen::Vector3f>& target,
                            const std::vector<Eigen::Vector3f>& source, const Pose& start,
                            const PeerOptions& options);

/// PCL's point-to-point ICP.
PeerOutcome alignWithPclIcp(const std::vector<Eigen::Vector3f>& target,
                            const std::vector<Eigen::Vector3f>& source, const Pose& start,
                            const PeerOptions& options);

}  // namespace vestige
