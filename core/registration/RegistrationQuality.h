#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/Pose.h"
#include "core/geometry/PoseUncertainty.h"

namespace vestige {

/// What a registration says of itself (docs/formats.md has the words of the JSON).
enum class Verdict {
    accepted,  ///< the pose can be relied on, within its covariance
    doubtful,  ///< usable with the warning that the reasons give
    failed,    ///< no pose to rely on
    ambiguous  ///< several poses that the data cannot tell apart: RegistrationResult::candidates
};
std::string_view describe(Verdict verdict);

/// A pose that a search proposes, and how well it explains the data.
struct PoseCandidate {
    Similarity targetFromSource;
    double score = 0;  ///< 0 to 1, higher is better
};

/// Signed distances of the inlier source points to the target's local planes.
struct ResidualHistogram {
    double width_m = 0;               ///< of one bin; the bins lie evenly round zero
    std::vector<std::size_t> counts;  ///< an odd number of bins
    std::size_t outside = 0;          ///< inliers beyond the first and last bin
};

/// One eigenvector of the Hessian: a way the source can move, and how much the data resist.
struct ObservedDirection {
    double information = 0;                 ///< eigenvalue, 1 / m^2: large is well held
    Vector6d direction = Vector6d::Zero();  ///< unit vector of (t, r w), metres, target's axes
    double sigma_m = 0;                     ///< standard deviation of the pose along it
    bool free = false;                      ///< the data do not hold it
    std::string words;                      ///< "slides along the road (east-west)", for people
};

/// How far the result moves when the start is perturbed.
struct RestartSpread {
    int runs = 0;
    int agreeing = 0;          ///< within the spread that the covariance allows
    double translation_m = 0;  ///< largest distance of an agreeing run's pose at the source's centroid
    double rotation_rad = 0;
};

/// The evidence on which a verdict stands.
struct RegistrationQuality {
    ResidualHistogram residuals;
    double planeRmse_m = 0;  ///< of the inliers' distances to the target's local planes
    RestartSpread restarts;
    std::vector<ObservedDirection> directions;  ///< six, the least observed first
    double radius_m = 0;  ///< r of the directions: RMS distance of the source from its centroid
    PoseUncertainty uncertainty;
};

}  // namespace vestige
