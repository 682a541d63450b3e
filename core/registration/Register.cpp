#include "core/registration/Register.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "core/base/Numbers.h"
#include "core/registration/FindPose.h"

namespace vestige {
namespace {

constexpr double kMeshSamples = 1e6;
/// A fit that leaves a known first pose by more of its standard deviations has gone astray.
constexpr double kMovesAllowed = 10;
constexpr double kMovesOfRadius = 0.1;

PointCloud pointsOf(const TriangleMesh& geometry) {
    if (!geometry.isMesh()) return geometry.vertices;
    return sampleSurface(geometry, std::sqrt(surfaceArea(geometry) / kMeshSamples));
}

std::string percent(double share) {
    return fixedText(100 * share, 1) + " %";
}

/// How far the fit moved the source's surface from its first pose, at most.
double movedBy(const RegistrationResult& result, const PointCloud& source) {
    const Eigen::Vector3d centre = source.bounds().centre();
    const double shift = (result.targetFromSource * centre - result.initial * centre).norm();
    const double turn =
        rotationAngle(result.initial.pose.linear().transpose() * result.targetFromSource.pose.linear());
    return shift + turn * result.radius_m;
}

/// Why nobody should rely on the pose. Either cloud may be the small one, so the better of the two overlaps
/// counts.
std::vector<std::string> reasonsAgainst(const RegistrationResult& result, double moved_m, double allowed_m) {
    constexpr double kLeastOverlap = 0.1;
    constexpr double kOverlapIfNotConverged = 0.3;
    std::vector<std::string> reasons;
    if (moved_m > allowed_m)
        reasons.push_back("the fit moved the source " + fixedText(moved_m, 2) +
                          " m from a first pose that is known much better than that");
    const double overlap = std::max(result.overlap, result.targetOverlap);
    if (overlap < kLeastOverlap)
        reasons.push_back("only " + percent(result.overlap) + " of the source lies within " +
                          fixedText(result.inlierDistance_m, 3) + " m of the target");
    else if (!result.converged && overlap < kOverlapIfNotConverged)
        reasons.push_back("it has not converged and only " + percent(result.overlap) +
                          " of the source lies on the target");
    return reasons;
}

/// Judges a pose that was found: the verdict and its reasons.
void assess(RegistrationResult& result, const PointCloud& source, const ParameterSet& parameters) {
    const auto startError_m = parameters.optionalReal("start_error_m");
    const double allowed_m = startError_m
                                 ? std::max(kMovesAllowed * *startError_m, kMovesOfRadius * result.radius_m)
                                 : std::numeric_limits<double>::infinity();
    result.reasons = reasonsAgainst(result, movedBy(result, source), allowed_m);
    if (!result.reasons.empty()) result.verdict = Verdict::failed;
}

}  // namespace

Result<RegistrationResult> attemptRegistration(const TriangleMesh& target, const TriangleMesh& source,
                                               const Similarity& initial, const ParameterSet& parameters,
                                               const JobControl& control, const RegistrationWatch& watch) {
    return guarded("registration", [&]() -> Result<RegistrationResult> {
        const auto begin = std::chrono::steady_clock::now();
        const PointCloud targetPoints = pointsOf(target);
        const PointCloud sourcePoints = pointsOf(source);
        Result<RegistrationResult> result =
            findPose(targetPoints, sourcePoints, initial, parameters, control, watch);
        if (!result) return result;
        assess(*result, sourcePoints, parameters);
        result->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        control.progress(1, "registration");
        return result;
    });
}

Result<RegistrationResult> registerGeometry(const TriangleMesh& target, const TriangleMesh& source,
                                            const Similarity& initial, const ParameterSet& parameters,
                                            const JobControl& control, const RegistrationWatch& watch) {
    Result<RegistrationResult> result =
        attemptRegistration(target, source, initial, parameters, control, watch);
    if (result && !result->trustworthy()) {
        Error error{ErrorCode::untrustworthy,
                    "the registration cannot be relied on",
                    {},
                    "check that the clouds show the same place, and give a nearer first pose"};
        error.message.append(": ").append(result->reasons.front());
        return fail(std::move(error));
    }
    return result;
}

}  // namespace vestige
