#include "core/registration/quality/Restarts.h"

#include <Eigen/LU>

#include "core/base/Random.h"
#include "core/registration/quality/SurfaceFit.h"

namespace vestige {
namespace {

constexpr std::uint64_t kSeed = 20250316;  // any: the same starts on every run
constexpr double kChiSquare95 = 12.592;    // of six degrees of freedom

Eigen::Vector3d randomDirection(Random& random) {
    const double x = random.normal();
    const double y = random.normal();
    const double z = random.normal();
    return Eigen::Vector3d(x, y, z).normalized();
}

RestartOutcome outcomeOf(const Pose& found, const Pose& pose, const RestartPlan& plan) {
    RestartOutcome outcome{pose, stepBetween(found, pose, plan.pivot_m, plan.radius_m), false};
    // Two results differ by the errors of both.
    const Eigen::LDLT<Matrix6d> covariance((2 * plan.covariance).eval());
    outcome.agrees = outcome.step.norm() <= plan.tolerance_m ||
                     outcome.step.dot(covariance.solve(outcome.step)) <= kChiSquare95;
    return outcome;
}

}  // namespace

std::vector<RestartOutcome> restart(const Pose& found, const RestartPlan& plan, const RegisterAgain& again,
                                    const JobControl& control) {
    std::vector<RestartOutcome> outcomes;
    for (int i = 0; i < plan.runs; ++i) {
        if (control.cancelled()) throw ErrorException{cancelledError()};
        Random random(kSeed, static_cast<std::uint64_t>(i));
        Vector6d start;
        start.head<3>() = plan.distance_m * randomDirection(random);
        start.tail<3>() = plan.distance_m * randomDirection(random);
        const Result<Pose> pose = again(stepped(found, start, plan.pivot_m, plan.radius_m));
        if (pose) outcomes.push_back(outcomeOf(found, *pose, plan));
        control.progress(static_cast<double>(i + 1) / plan.runs, "restarts");
    }
    return outcomes;
}

}  // namespace vestige
