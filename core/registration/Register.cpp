#include "core/registration/Register.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "core/base/Numbers.h"
#include "core/registration/ImprovedNdt.h"
#include "core/registration/PeerMethods.h"

namespace vestige {
namespace {

constexpr double kMeshSamples = 1e6;
constexpr double kLargestStart_m = 4;
constexpr double kPaperStart_m = 1;  // the largest size of the publication's table 2
constexpr double kFloor_m = 0.1;
constexpr double kPeerVoxel_m = 1;
/// A first pose that is known needs no cells that reach further than it may be off, 2 sigma to either side.
/// Smaller cells than this share of the source's radius hold too little of a surface (docs/decisions/0005).
constexpr double kStartErrorsPerCell = 4;
constexpr double kSmallestKnownStart = 1.0 / 4;
/// A fit that leaves a known first pose by more of its standard deviations has gone astray.
constexpr double kMovesAllowed = 10;
constexpr double kMovesOfRadius = 0.1;

PointCloud pointsOf(const TriangleMesh& geometry) {
    if (!geometry.isMesh()) return geometry.vertices;
    return sampleSurface(geometry, std::sqrt(surfaceArea(geometry) / kMeshSamples));
}

ImprovedNdtOptions ndtOptions(const ParameterSet& parameters, double sourceRadius_m) {
    const bool paper = parameters.text("preset") == "paper";
    ImprovedNdtOptions options;
    options.voxelStart_m = parameters.optionalReal("voxel_start_m")
                               .value_or(paper ? kPaperStart_m : std::min(kLargestStart_m, sourceRadius_m));
    const auto startError_m = parameters.optionalReal("start_error_m");
    if (startError_m && !paper && !parameters.optionalReal("voxel_start_m"))
        options.voxelStart_m = std::min(options.voxelStart_m, std::max(kStartErrorsPerCell * *startError_m,
                                                                       kSmallestKnownStart * sourceRadius_m));
    options.voxel_m = parameters.optionalReal("voxel_m");
    // A small thing needs smaller cells than a street.
    options.voxelFloor_m = std::min(kFloor_m, options.voxelStart_m / 20);
    options.leaf_m = parameters.optionalReal("leaf_m");
    options.coarserCells = !paper;
    options.shiftedGrids = paper ? 1 : 4;
    if (startError_m && !paper)
        options.voxelFloor_m = std::max(options.voxelFloor_m,
                                        std::min(options.voxelStart_m, kSmallestKnownStart * sourceRadius_m));
    if (!paper) options.voxelCeiling_m = std::max(options.voxelFloor_m, sourceRadius_m / 5);
    options.distributions.flatCellsInPlane = paper;
    options.distributions.outlierRatio = parameters.real("outlier_ratio");
    options.distributions.flatness = parameters.real("flatness");
    const auto noise_m = parameters.optionalReal("range_noise_m");
    options.distributions.rangeNoise_m = noise_m.value_or(0);
    options.estimateNoise = startError_m && !noise_m && !paper;
    options.trustRegion.startRadius_m = parameters.real("trust_radius_m");
    options.trustRegion.damping = parameters.real("damping");
    options.trustRegion.gradientLimit = parameters.real("gradient_limit");
    options.trustRegion.stepLimit_m = parameters.real("step_limit_m");
    options.trustRegion.iterationLimit = static_cast<int>(parameters.integer("max_iterations"));
    return options;
}

PeerMethodOptions peerOptions(const ParameterSet& parameters, double sourceRadius_m) {
    PeerMethodOptions options;
    options.method = parameters.text("method");
    options.voxel_m = parameters.optionalReal("voxel_m").value_or(std::min(kPeerVoxel_m, sourceRadius_m / 4));
    options.leaf_m = parameters.optionalReal("leaf_m");
    if (!parameters.isDefault("outlier_ratio")) options.outlierRatio = parameters.real("outlier_ratio");
    options.rangeNoise_m = parameters.optionalReal("range_noise_m").value_or(0);
    options.iterationLimit = static_cast<int>(parameters.integer("max_iterations"));
    return options;
}

std::string percent(double share) {
    return fixedText(100 * share, 1) + " %";
}

/// How far the fit moved the source's surface from its first pose, at most.
double movedBy(const RegistrationResult& result, const PointCloud& source, double radius_m) {
    const Eigen::Vector3d centre = source.bounds().centre();
    const double shift = (result.targetFromSource * centre - result.initial * centre).norm();
    const double turn =
        rotationAngle(result.initial.pose.linear().transpose() * result.targetFromSource.pose.linear());
    return shift + turn * radius_m;
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

}  // namespace

Result<RegistrationResult> attemptRegistration(const TriangleMesh& target, const TriangleMesh& source,
                                               const Similarity& initial, const ParameterSet& parameters,
                                               const JobControl& control, const RegistrationWatch& watch) {
    return guarded("registration", [&]() -> Result<RegistrationResult> {
        const auto begin = std::chrono::steady_clock::now();
        const PointCloud targetPoints = pointsOf(target);
        const PointCloud sourcePoints = pointsOf(source);
        if (targetPoints.empty() || sourcePoints.empty())
            return fail(ErrorCode::untrustworthy,
                        targetPoints.empty() ? "the target is empty" : "the source is empty");
        const double radius = initial.scale * surfaceRadius(sourcePoints);
        if (!(radius > 0))
            return fail(ErrorCode::untrustworthy, "the source has no extent, it cannot be registered");
        const ImprovedNdtOptions ndt = ndtOptions(parameters, radius);
        const double margin = 2 * std::max(ndt.voxelStart_m, ndt.voxel_m.value_or(0)) + 0.5 * radius;
        const RegistrationFrame frame(targetPoints, sourcePoints, initial, margin);
        Result<RegistrationResult> result =
            parameters.text("method") == "improved-ndt"
                ? improvedNdt(frame, initial, ndt, control, watch)
                : peerMethod(frame, initial, peerOptions(parameters, radius), control);
        if (!result) return result;
        result->method = parameters.text("method");
        result->initial = initial;
        const auto startError_m = parameters.optionalReal("start_error_m");
        const double allowed_m = startError_m
                                     ? std::max(kMovesAllowed * *startError_m, kMovesOfRadius * radius)
                                     : std::numeric_limits<double>::infinity();
        result->reasons = reasonsAgainst(*result, movedBy(*result, sourcePoints, radius), allowed_m);
        if (!result->reasons.empty()) result->verdict = Verdict::failed;
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
