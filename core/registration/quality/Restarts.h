#pragma once

#include <vector>

#include "core/base/JobControl.h"
#include "core/registration/quality/Assess.h"

namespace vestige {

/// Where a registration ends that starts near a pose.
struct RestartOutcome {
    Pose pose;
    Vector6d step = Vector6d::Zero();  ///< from the result, (t, r w) about the pivot, metres
    bool agrees = false;
};

struct RestartPlan {
    int runs = 0;
    double distance_m = 0;  ///< of the starts from the result, and of the turn at the radius
    Eigen::Vector3d pivot_m = Eigen::Vector3d::Zero();
    double radius_m = 1;
    Matrix6d covariance = Matrix6d::Zero();  ///< of (t, r w)
    double tolerance_m = 0;                  ///< a step shorter than this agrees in any case
};

/// Runs the registration from starts in fixed pseudo-random directions; one that finds nothing counts as one
/// that disagrees and leaves no outcome. Throws ErrorException when the job is cancelled.
std::vector<RestartOutcome> restart(const Pose& found, const RestartPlan& plan, const RegisterAgain& again,
                                    const JobControl& control);

}  // namespace vestige
