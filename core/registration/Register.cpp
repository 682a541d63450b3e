#include "core/registration/Register.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/base/Numbers.h"
#include "core/registration/FindPose.h"
#include "core/registration/quality/Assess.h"

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

/// How far the fit moved the source's surface from its first pose, at most.
double movedBy(const RegistrationResult& result, const PointCloud& source) {
    const Eigen::Vector3d centre = source.bounds().centre();
    const double shift = (result.targetFromSource * centre - result.initial * centre).norm();
    const double turn =
        rotationAngle(result.initial.pose.linear().transpose() * result.targetFromSource.pose.linear());
    return shift + turn * result.radius_m;
}

/// A known first pose that the fit left by much more than its error speaks against the result.
void checkMove(RegistrationResult& result, const PointCloud& source, const ParameterSet& parameters) {
    const auto startError_m = parameters.optionalReal("start_error_m");
    if (!startError_m) return;
    const double moved_m = movedBy(result, source);
    if (moved_m <= std::max(kMovesAllowed * *startError_m, kMovesOfRadius * result.radius_m)) return;
    if (result.verdict == Verdict::accepted) result.reasons.clear();
    result.verdict = Verdict::failed;
    result.reasons.insert(result.reasons.begin(),
                          "the fit moved the source " + fixedText(moved_m, 2) +
                              " m from a first pose that is known much better than that");
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
            findPose(targetPoints, sourcePoints, initial, parameters, control.sub(0, 0.5), watch);
        if (!result) return result;
        result->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        const RegisterAgain again = [&](const Pose& start) -> Result<Pose> {
            auto other = findPose(targetPoints, sourcePoints, {start, initial.scale}, parameters);
            if (!other) return fail(other.error());
            return other->targetFromSource.pose;
        };
        assess(*result, targetPoints, sourcePoints, qualityOptions(parameters), again, control.sub(0.5, 1));
        checkMove(*result, sourcePoints, parameters);
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
