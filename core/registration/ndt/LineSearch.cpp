#include "core/registration/ndt/LineSearch.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace vestige {
namespace {

constexpr double kEnough = 1e-4;  // of the decrease that the slope promises
constexpr int kHalvings = 12;

Vector6d newtonStep(const ScoredPose& scored, double damping, double longest) {
    const Eigen::SelfAdjointEigenSolver<Matrix6d> solver(scored.hessian);
    const Vector6d values = solver.eigenvalues().cwiseAbs().cwiseMax(damping);
    const Vector6d components = solver.eigenvectors().transpose() * scored.gradient;
    const Vector6d step = -(solver.eigenvectors() * components.cwiseQuotient(values));
    return step * std::min(1.0, longest / std::max(step.norm(), 1e-300));
}

}  // namespace

TrustRegionOutcome minimiseByLineSearch(const NdtScore& score, const Pose& start, double radius,
                                        const TrustRegionOptions& options, const TrustRegionWatch& watch) {
    TrustRegionOutcome best{start, score(start), 0, StopReason::iterationLimit};
    if (watch) watch(best, {options.largestRadius_m, 0, true});
    const auto stopped = [&](StopReason reason) {
        best.stop = reason;
        return best;
    };
    while (best.iterations < options.iterationLimit) {
        if (best.scored.inside == 0) return stopped(StopReason::noOverlap);
        if (best.scored.gradient.norm() < options.gradientLimit) return stopped(StopReason::gradient);
        Vector6d step = newtonStep(best.scored, options.damping, options.largestRadius_m);
        if (step.norm() < options.stepLimit_m) return stopped(StopReason::step);
        const double slope = best.scored.gradient.dot(step);
        ++best.iterations;
        bool taken = false;
        for (int halving = 0; halving < kHalvings && !taken; ++halving) {
            const double share = std::ldexp(1.0, -halving);
            const Pose pose = NdtScore::moved(best.pose, share * step, radius);
            if (score.value(pose) > best.scored.score + kEnough * share * slope) continue;
            best.pose = pose;
            best.scored = score(pose);
            step *= share;
            taken = true;
        }
        if (watch) watch(best, {options.largestRadius_m, step.norm(), taken});
        // No shorter step lowers the score: what is left is rounding.
        if (!taken) return stopped(StopReason::predictedDecrease);
    }
    return best;
}

}  // namespace vestige
