#include "core/registration/quality/Assess.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/registration/RegistrationFrame.h"
#include "core/registration/quality/Judge.h"
#include "core/registration/quality/Observability.h"
#include "core/registration/quality/ResidualStatistics.h"
#include "core/registration/quality/Restarts.h"
#include "core/registration/quality/SurfaceFit.h"

namespace vestige {
namespace {

/// What the sandwich leaves out, found on simulated pairs with truth (docs/decisions/0009).
constexpr double kVarianceScale = 1.9;
/// Of the finest cell: how well cells of that size can stand for a surface at all.
constexpr double kCellError = 1.6e-4;
/// Of the squared step between the two fits: it holds the errors of both.
constexpr double kStepShare = 0.5;
constexpr double kChiSquare95 = 12.592;  // of six degrees of freedom
constexpr double kMargin = 0.5;          // of the source's radius, round its bounds
constexpr double kRestartOfRadius = 0.03;
constexpr double kAsGood = 0.95;
constexpr double kBetter = 1.05;

/// Of (t, r w) of the found pose: that of the least-squares pose nearby, and the step to it.
Matrix6d covarianceOf(const PoseInformation& information, const Vector6d& step, double cell_m) {
    const double least = kCellError * cell_m;
    return kVarianceScale * information.covariance() + kStepShare * step * step.transpose() +
           least * least * Matrix6d::Identity();
}

/// From (t, r w) to (t, w).
Matrix6d inRadians(const Matrix6d& covariance, double radius_m) {
    Vector6d scale;
    scale << 1, 1, 1, 1 / radius_m, 1 / radius_m, 1 / radius_m;
    return scale.asDiagonal() * covariance * scale.asDiagonal();
}

/// How well a pose explains both clouds: to compare poses of one pair.
double scoreOf(const SurfaceFit& fit, const Pose& pose) {
    const SurfaceShares source = fit.sourceShares(pose);
    const SurfaceShares target = fit.targetShares(pose);
    return source.agrees + target.agrees + source.support + target.support;
}

/// Restarts near the result and turned by half: how many come back, and whether another pose fits as well.
void tryAgain(const RegistrationResult& result, const SurfaceFit& fit, const RestartPlan& plan,
              const std::function<Pose(const Pose&)>& toLocal, const Eigen::Vector3d& middle,
              const RegisterAgain& again, const JobControl& control, RegistrationQuality& quality,
              Evidence& evidence) {
    const Pose& found = result.targetFromSource.pose;
    const std::array centres{plan.pivot_m, middle};
    std::vector<RestartOutcome> outcomes = restart(found, plan, again, control.sub(0, 0.8));
    quality.restarts.runs = plan.runs;
    for (const RestartOutcome& outcome : outcomes) {
        if (!outcome.agrees) continue;
        ++quality.restarts.agreeing;
        quality.restarts.translation_m =
            std::max(quality.restarts.translation_m, outcome.step.head<3>().norm());
        quality.restarts.rotation_rad =
            std::max(quality.restarts.rotation_rad, outcome.step.tail<3>().norm() / plan.radius_m);
    }
    const std::size_t near = outcomes.size();
    const auto turned = restartTurned(found, plan, centres, again, control.sub(0.8, 1));
    outcomes.insert(outcomes.end(), turned.begin(), turned.end());
    const double score = scoreOf(fit, toLocal(found));
    double best = kAsGood * score;
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        if (outcomes[i].agrees) continue;
        const double other = scoreOf(fit, toLocal(outcomes[i].pose));
        if (other <= best) continue;
        best = other;
        evidence.betterElsewhere_m = outcomes[i].step.norm();
        // From behind, a hall may look better by chance of where the stations stood.
        evidence.muchBetter = i < near && other > kBetter * score;
    }
}

}  // namespace

void assess(RegistrationResult& result, const PointCloud& target, const PointCloud& source,
            const QualityOptions& options, const RegisterAgain& again, const JobControl& control) {
    RegistrationQuality quality;
    Evidence evidence;
    const RegistrationFrame frame(target, source, result.targetFromSource, kMargin * result.radius_m);
    const CentredSource centred = frame.centred(frame.source());
    const SurfaceFit fit(frame.target(), centred.points, result.radius_m);
    const Pose found = frame.toLocal(result.targetFromSource.pose, centred);
    const Eigen::Vector3d origin =
        result.targetFromSource.pose * centred.centre - found.translation();  // of the frame, in the target
    control.progress(0.2, "quality");

    const ResidualStatistics residuals =
        residualStatistics(centred.points, found, fit.target(), result.inlierDistance_m);
    quality.residuals = residuals.histogram;
    quality.planeRmse_m = residuals.rmse_m;
    const Pose refined = fit.refined(found);
    const PoseInformation information = fit.information(refined);
    quality.radius_m = information.radius_m;
    const Matrix6d covariance = covarianceOf(
        information, stepBetween(found, refined, information.pivot_m, information.radius_m), fit.finest_m());
    quality.directions = observedDirections(information, covariance, options.freeSigma_m);
    quality.uncertainty = {inRadians(covariance, information.radius_m), information.pivot_m + origin};
    evidence.longestHalfAxis_m = std::sqrt(
        kChiSquare95 *
        Eigen::SelfAdjointEigenSolver<Matrix6d>(covariance, Eigen::EigenvaluesOnly).eigenvalues()[5]);
    evidence.source = fit.sourceShares(found);
    evidence.target = fit.targetShares(found);
    control.progress(0.3, "quality");

    RestartPlan plan;
    plan.runs = options.restarts;
    plan.distance_m = std::max(kRestartOfRadius * information.radius_m,
                               std::min(evidence.longestHalfAxis_m, 0.1 * information.radius_m));
    plan.pivot_m = information.pivot_m + origin;
    plan.radius_m = information.radius_m;
    plan.covariance = covariance;
    plan.tolerance_m = 0.5 * fit.tolerance_m();
    if (options.restarts > 0)
        tryAgain(
            result, fit, plan, [&](const Pose& pose) { return frame.toLocal(pose, centred); },
            fit.middle(found) + origin, again, control.sub(0.3, 1), quality, evidence);
    Judgement judgement = judge(result, quality, evidence, options);
    result.verdict = judgement.verdict;
    result.reasons = std::move(judgement.reasons);
    result.quality = std::move(quality);
    control.progress(1, "quality");
}

}  // namespace vestige
