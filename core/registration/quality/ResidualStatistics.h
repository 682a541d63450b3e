#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/geometry/Pose.h"
#include "core/registration/RegistrationQuality.h"
#include "core/registration/quality/SurfaceCells.h"

namespace vestige {

struct ResidualStatistics {
    ResidualHistogram histogram;
    double rmse_m = 0;
    double sigma_m = 0;  ///< robust (MAD)
};

/// Signed distances of the points (at most some twenty thousand of them, evenly taken), moved by `pose`, to
/// the target's local planes, as far as they are no longer than `limit_m`. Positive is the side that the
/// plane's largest component of the normal points to.
ResidualStatistics residualStatistics(const std::vector<Eigen::Vector3f>& points, const Pose& pose,
                                      const SurfaceIndex& target, double limit_m);

}  // namespace vestige
