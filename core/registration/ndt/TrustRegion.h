#pragma once

#include <functional>

#include "core/registration/RegistrationResult.h"
#include "core/registration/ndt/NdtScore.h"

namespace vestige {

struct TrustRegionOptions {
    double startRadius_m = 0.1;    ///< Delta_0
    double largestRadius_m = 1;    ///< the voxel size
    double damping = 0.01;         ///< lambda
    double gradientLimit = 1e-6;   ///< |g|
    double stepLimit_m = 1e-5;     ///< |dp|
    double decreaseLimit = 1e-12;  ///< predicted decrease over |S|
    int iterationLimit = 50;
};

/// The minimiser of the quadratic model within the bound, and what the model says of it.
struct TrustRegionStep {
    Vector6d step = Vector6d::Zero();
    double predictedDecrease = 0;  ///< of the model with H itself, undamped
    bool bounded = false;          ///< |step| is the bound
};

/// METHOD section 3, step 4: dp = -(H + mu I)^-1 g with the smallest mu >= lambda that makes H + mu I
/// positive definite and |dp| <= bound, exactly, in the eigenbasis of H (Conn, Gould, Toint 2000,
/// section 7.3).
TrustRegionStep trustRegionStep(const Vector6d& gradient, const Matrix6d& hessian, double bound,
                                double damping);

struct TrustRegionOutcome {
    Pose pose = Pose::Identity();
    ScoredPose scored;
    int iterations = 0;
    StopReason stop = StopReason::iterationLimit;
};

/// What an iteration tried; `bound` is the one for the next.
struct TrustRegionTrial {
    double bound = 0;
    double length = 0;
    bool taken = true;
};
using TrustRegionWatch = std::function<void(const TrustRegionOutcome&, const TrustRegionTrial&)>;

/// Minimises `score` from `start`; `radius` turns the last three components of a step into radians.
TrustRegionOutcome minimise(const std::function<ScoredPose(const Pose&)>& score, const Pose& start,
                            double radius, const TrustRegionOptions& options,
                            const TrustRegionWatch& watch = {});

}  // namespace vestige
