#include "core/registration/ndt/TrustRegion.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace vestige {
namespace {

/// |(H + mu I)^-1 g| in the eigenbasis.
double stepLength(const Vector6d& values, const Vector6d& components, double mu) {
    double sum = 0;
    for (int i = 0; i < 6; ++i) {
        if (components[i] == 0) continue;
        const double part = components[i] / (values[i] + mu);
        sum += part * part;
    }
    return std::sqrt(sum);
}

/// The mu above `low` at which the step has length `bound`; at `low` it is longer. The length falls with mu.
double muOfLength(const Vector6d& values, const Vector6d& components, double low, double bound) {
    double high = std::max(low, -values[0]) + components.norm() / bound;
    for (int i = 0; i < 200 && high - low > 1e-15 * std::abs(high); ++i) {
        const double middle = 0.5 * (low + high);
        (stepLength(values, components, middle) > bound ? low : high) = middle;
    }
    return high;
}

}  // namespace

TrustRegionStep trustRegionStep(const Vector6d& gradient, const Matrix6d& hessian, double bound,
                                double damping) {
    const Eigen::SelfAdjointEigenSolver<Matrix6d> solver(hessian);
    const Vector6d& values = solver.eigenvalues();  // ascending
    const Vector6d components = solver.eigenvectors().transpose() * gradient;
    // Positive definite with room for rounding.
    const double room = 1e-12 * std::max(1.0, values.cwiseAbs().maxCoeff());
    double mu = std::max(damping, room - values[0]);
    TrustRegionStep result;
    Vector6d step;
    if (stepLength(values, components, mu) > bound) {
        mu = muOfLength(values, components, mu, bound);
        result.bounded = true;
    }
    for (int i = 0; i < 6; ++i) step[i] = -components[i] / (values[i] + mu);
    // The hard case: no slope along the direction of negative curvature. The rest of the bound goes there.
    const double left = bound * bound - step.squaredNorm();
    if (!result.bounded && values[0] < 0 && left > 0) {
        step[0] += (components[0] > 0 ? -1 : 1) * std::sqrt(left);
        step *= std::min(1.0, bound / step.norm());
        result.bounded = true;
    }
    result.predictedDecrease = -(components.dot(step) + 0.5 * step.dot(values.cwiseProduct(step)));
    result.step = solver.eigenvectors() * step;
    return result;
}

TrustRegionOutcome minimise(const std::function<ScoredPose(const Pose&)>& score, const Pose& start,
                            double radius, const TrustRegionOptions& options, const TrustRegionWatch& watch) {
    TrustRegionOutcome best{start, score(start), 0, StopReason::iterationLimit};
    double bound = std::min(options.startRadius_m, options.largestRadius_m);
    if (watch) watch(best, {bound, 0, true});
    while (best.iterations < options.iterationLimit) {
        if (best.scored.inside == 0) {
            best.stop = StopReason::noOverlap;
            return best;
        }
        if (best.scored.gradient.norm() < options.gradientLimit) {
            best.stop = StopReason::gradient;
            return best;
        }
        const TrustRegionStep trial =
            trustRegionStep(best.scored.gradient, best.scored.hessian, bound, options.damping);
        if (trial.step.norm() < options.stepLimit_m) {
            best.stop = StopReason::step;
            return best;
        }
        if (trial.predictedDecrease < options.decreaseLimit * std::abs(best.scored.score)) {
            best.stop = StopReason::predictedDecrease;
            return best;
        }
        ++best.iterations;
        const Pose pose = NdtScore::moved(best.pose, trial.step, radius);
        ScoredPose scored = score(pose);
        const double gain = (best.scored.score - scored.score) / trial.predictedDecrease;
        if (gain < 0.25) {
            bound = 0.5 * std::min(bound, trial.step.norm());
        } else if (gain > 0.75 && trial.bounded) {
            bound = std::min(1.5 * bound, options.largestRadius_m);
        }
        const bool taken = scored.score < best.scored.score;
        if (taken) {
            best.pose = pose;
            best.scored = scored;
        }
        if (watch) watch(best, {bound, trial.step.norm(), taken});
    }
    return best;
}

}  // namespace vestige
