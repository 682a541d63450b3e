#include "core/registration/quality/Assess.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/registration/RegistrationFrame.h"
#include "core/registration/quality/DirectionWords.h"
#include "core/registration/quality/FreeSpace.h"
#include "core/registration/quality/Judge.h"
#include "core/registration/quality/Observability.h"
#include "core/registration/quality/ResidualStatistics.h"
#include "core/registration/quality/Restarts.h"
#include "core/registration/quality/RivalPoses.h"
#include "core/registration/quality/SurfaceFit.h"

namespace vestige {
namespace {

/// What the sandwich leaves out, found on simulated pairs with truth (docs/decisions/0009).
constexpr double kVarianceScale = 0.8;
/// Of the finest cell: how well cells of that size can stand for a surface at all.
constexpr double kCellError = 1.1e-4;
/// Of the squared step between the two fits: it holds the errors of both.
constexpr double kStepShare = 0.5;
constexpr double kChiSquare95Of3 = 7.815;
constexpr double kMargin = 0.5;  // of the source's radius, round its bounds
constexpr double kRestartOfRadius = 0.03;
constexpr double kFarthestOfRadius = 0.1;
constexpr double kApartOfRadius = 0.02;  // of poses that count as others
constexpr double kWorthATry = 0.4;       // of the found pose's score
constexpr double kLargestSeen = 8;       // finest cells: of surface that free space is asked about

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

/// The half axis of a 95 % ellipsoid of three of p's components, where it is longest.
Reach longestOf(const Matrix6d& covariance, Eigen::Index first) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance.block<3, 3>(first, first));
    Vector6d motion = Vector6d::Zero();
    motion.segment<3>(first) = solver.eigenvectors().col(2);
    return {std::sqrt(kChiSquare95Of3 * std::max(0.0, solver.eigenvalues()[2])), motionWords(motion)};
}

/// Starts near the result: how many come back, and where the others end.
void tryAgain(const RegistrationResult& result, const RestartPlan& plan, const RegisterAgain& again,
              const JobControl& control, RegistrationQuality& quality, std::vector<RestartOutcome>& astray) {
    quality.restarts.runs = plan.runs;
    for (const RestartOutcome& outcome : restart(result.targetFromSource.pose, plan, again, control)) {
        if (!outcome.agrees) {
            astray.push_back(outcome);
            continue;
        }
        ++quality.restarts.agreeing;
        quality.restarts.translation_m =
            std::max(quality.restarts.translation_m, outcome.step.head<3>().norm());
        quality.restarts.rotation_rad =
            std::max(quality.restarts.rotation_rad, outcome.step.tail<3>().norm() / plan.radius_m);
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
    evidence.shift = longestOf(covariance, 0);
    evidence.turn = longestOf(covariance, 3);
    evidence.turn.size /= information.radius_m;
    evidence.radius_m = information.radius_m;
    evidence.source = fit.sourceShares(found);
    evidence.target = fit.targetShares(found);
    evidence.score = poseScore(evidence.source, evidence.target);
    const FreeSpace space({frame.target(), fit.target().cells(), -origin},
                          {centred.points, fit.source().cells(), -centred.centre}, fit.tolerance_m(),
                          kLargestSeen * fit.finest_m());
    evidence.through = space.through(found);
    evidence.freeSpaceKnown = space.known();
    control.progress(0.3, "quality");

    RestartPlan plan;
    plan.runs = options.restarts;
    const double uncertain_m = std::max(evidence.shift.size, evidence.turn.size * information.radius_m);
    plan.distance_m = std::max(kRestartOfRadius * information.radius_m,
                               std::min(uncertain_m, kFarthestOfRadius * information.radius_m));
    plan.pivot_m = information.pivot_m + origin;
    plan.radius_m = information.radius_m;
    plan.covariance = covariance;
    plan.tolerance_m = 0.5 * fit.tolerance_m();
    std::vector<RestartOutcome> astray;
    tryAgain(result, plan, again, control.sub(0.3, 0.9), quality, astray);
    for (const RestartOutcome& outcome : astray) {
        const Pose pose = frame.toLocal(outcome.pose, centred);
        evidence.rivals.push_back({outcome.step.norm(), poseScore(fit, pose), space.through(pose), true});
    }
    evidence.apart_m = std::max(kApartOfRadius * information.radius_m, 2 * uncertain_m);
    bool tried = false;
    for (RivalPose rival : rivalPoses(fit, found, evidence.apart_m)) {
        if (rival.score < kWorthATry * evidence.score) continue;
        double through = space.through(rival.pose);
        // One that free space prefers is worth a registration of its own; the cells alone may not get there.
        if (!tried && clearer(through, evidence.through)) {
            tried = true;
            if (const Result<Pose> pose = again(frame.toWorld(rival.pose, centred))) {
                const Pose local = frame.toLocal(*pose, centred);
                const double score = poseScore(fit, local);
                if (score > rival.score) rival = {local, score};
                through = space.through(rival.pose);
            }
        }
        evidence.rivals.push_back(
            {stepBetween(found, rival.pose, information.pivot_m, information.radius_m).norm(), rival.score,
             through, false});
    }
    Judgement judgement = judge(result, quality, evidence, options);
    result.verdict = judgement.verdict;
    result.reasons = std::move(judgement.reasons);
    result.quality = std::move(quality);
    control.progress(1, "quality");
}

}  // namespace vestige
