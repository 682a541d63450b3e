#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/Pose.h"
#include "core/registration/RegistrationQuality.h"

namespace vestige {

/// Why a level ended (METHOD section 3, step 4).
enum class StopReason { gradient, step, predictedDecrease, iterationLimit, noOverlap };
std::string_view describe(StopReason reason);

/// One voxel size of the schedule.
struct RegistrationLevel {
    double voxel_m = 0;
    int iterations = 0;
    double score = 0;
    StopReason stop = StopReason::gradient;
    Pose targetFromSource = Pose::Identity();
};

/// What a registration found. `targetFromSource` maps scaled source points (metres) into the target.
struct RegistrationResult {
    std::string method;  ///< "improved-ndt", "ndt", "icp"
    Similarity targetFromSource;
    bool converged = false;
    int iterations = 0;
    double seconds = 0;
    double rmse_m =
        0;  ///< of the distances of the inlier source points to the target's local planes or points
    double overlap = 0;           ///< share of source points with target within the inlier distance
    double targetOverlap = 0;     ///< share of the target near the source that holds such points
    double radius_m = 0;          ///< RMS distance of the source's surface from its centre
    double inlierDistance_m = 0;  ///< half the smallest voxel and three times the range noise
    std::vector<double> voxelSchedule_m;
    std::vector<RegistrationLevel> levels;
    std::vector<std::string> notes;  ///< for the user: unit recognised, what was chosen automatically and why
    Similarity initial;              ///< the first pose it started from
    Verdict verdict = Verdict::accepted;
    std::vector<std::string> reasons;       ///< for the verdict, in plain words
    std::vector<PoseCandidate> candidates;  ///< of an automatic first pose, the best first
    std::optional<RegistrationQuality> quality;
    std::vector<std::string> via;  ///< layers it was registered to, where they were not the target alone

    bool trustworthy() const { return verdict == Verdict::accepted || verdict == Verdict::doubtful; }
};

}  // namespace vestige
