#include "core/registration/global/JudgePoses.h"

#include <algorithm>
#include <cmath>

#include "core/base/Parallel.h"
#include "core/registration/global/PoseFit.h"

namespace vestige {
namespace {

// Lengths in voxels of the source's surfels.
constexpr double kShapeReach = 1.5;
constexpr double kFirstTolerance = 0.6;
constexpr double kSecondTolerance = 0.3;
constexpr double kCoverReach = 2;
constexpr double kLeastSigma = 0.1;
constexpr double kSameShift = 3;

constexpr std::size_t kPointsToRefine = 20000;
constexpr std::size_t kPointsToJudge = 60000;

float reachOf(const Surfels& source) {
    float most = 0;
    for (const Eigen::Vector3f& point : source.points) most = std::max(most, point.squaredNorm());
    return std::sqrt(most) + static_cast<float>(2 * source.voxel_m);
}

std::vector<Eigen::Vector3f> pointsNear(std::span<const Eigen::Vector3f> points,
                                        const Eigen::Vector3f& middle, float radius) {
    std::vector<Eigen::Vector3f> near;
    for (const Eigen::Vector3f& point : points)
        if ((point - middle).squaredNorm() < radius * radius) near.push_back(point);
    return near;
}

std::vector<Eigen::Vector3f> spread(const std::vector<Eigen::Vector3f>& points, std::size_t count) {
    if (points.size() <= count) return points;
    std::vector<Eigen::Vector3f> chosen;
    for (const std::uint32_t i : spreadIndices(points.size(), count)) chosen.push_back(points[i]);
    return chosen;
}

/// Half of it for surfaces that differ by this part of a voxel.
double scoreOfShape(const Evidence& evidence, double voxel_m) {
    constexpr double kAlike = 0.15;
    constexpr double kHalfSeen = 0.1;
    const double alike_m = kAlike * voxel_m;
    return (1 + kHalfSeen) * evidence.coverage / (evidence.coverage + kHalfSeen) /
           (1 + evidence.mostMismatch_m2() / (alike_m * alike_m));
}

/// Coverage counts, but the less the more there is of it.
double scoreOfCover(const Evidence& evidence) {
    return 1.25 * evidence.agreement * evidence.coverage / (evidence.coverage + 0.25);
}

/// The spread that the best of them shows: what all are held against.
double spreadOf(const std::vector<SurfaceCheck::Offsets>& offsets, double voxel_m) {
    std::size_t most = 0;
    for (const auto& one : offsets) most = std::max(most, knownOffsets(one));
    double sigma_m = kCoverReach * voxel_m;
    for (const auto& one : offsets) sigma_m = std::min(sigma_m, offsetScale(one, most / 2));
    return std::max(sigma_m, kLeastSigma * voxel_m);
}

}  // namespace

std::vector<JudgedPose> judgePoses(std::span<const Eigen::Vector3f> target, const Surfels& source,
                                   std::span<const Eigen::Vector3f> points,
                                   std::span<const ProposedPose> proposals, JudgeBy by) {
    const double voxel = source.voxel_m;
    const double reach_m = (by == JudgeBy::shape ? kShapeReach : kCoverReach) * voxel;
    const SurfaceLookup surface(source, voxel);
    const SurfaceReference reference = surfaceReference(points, surface);
    const float reach = reachOf(source);
    std::vector<JudgedPose> judged(proposals.size());
    std::vector<SurfaceCheck::Offsets> offsets(proposals.size());
    parallelFor(proposals.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Eigen::Isometry3d pose = proposals[i].targetFromSource;
            const auto near =
                spread(pointsNear(target, pose.translation().cast<float>(), reach), kPointsToJudge);
            const auto few = spread(near, kPointsToRefine);
            const SurfaceCheck rough(few, surface, reference);
            if (by == JudgeBy::shape) {
                pose = rough.refined(pose, reach_m, 20);
            } else {
                pose = rough.refined(pose, kFirstTolerance * voxel, 6);
                pose = rough.refined(pose, kSecondTolerance * voxel, 8);
            }
            judged[i].targetFromSource = pose;
            offsets[i] = SurfaceCheck(near, surface, reference).offsets(pose, reach_m);
        }
    });
    const double sigma_m = spreadOf(offsets, voxel);
    for (std::size_t i = 0; i < judged.size(); ++i) {
        judged[i].evidence = evidenceOf(offsets[i], reference, sigma_m);
        judged[i].score =
            by == JudgeBy::shape ? scoreOfShape(judged[i].evidence, voxel) : scoreOfCover(judged[i].evidence);
    }
    std::stable_sort(judged.begin(), judged.end(),
                     [](const JudgedPose& a, const JudgedPose& b) { return a.score > b.score; });
    std::vector<JudgedPose> kept;
    for (const JudgedPose& pose : judged)
        if (std::none_of(kept.begin(), kept.end(), [&](const JudgedPose& better) {
                return samePlace(pose.targetFromSource, better.targetFromSource, kSameShift * voxel);
            }))
            kept.push_back(pose);
    return kept;
}

bool rivals(const JudgedPose& other, const JudgedPose& best, JudgeBy by, double voxel_m, double margin) {
    const Evidence& a = other.evidence;
    const Evidence& b = best.evidence;
    if (by == JudgeBy::cover) {
        constexpr double kCoverage = 0.8;
        return a.agreement >= (1 - margin) * b.agreement && a.coverage >= kCoverage * b.coverage;
    }
    constexpr double kCoverage = 0.25;
    constexpr double kTimes = 2;
    constexpr double kNoDifference = 0.05;  // of a voxel: shapes that differ by that are alike
    constexpr double kSystematic = 0.02;    // of a voxel: what noise does not explain
    constexpr double kSigmas = 3;
    const double slack_m = kNoDifference * voxel_m;
    const double systematic_m = kSystematic * voxel_m;
    const double worse_m2 = std::max(0.0, a.mismatch_m2) - std::max(0.0, b.mismatch_m2);
    return a.coverage >= kCoverage * b.coverage &&
           a.mostMismatch_m2() <= kTimes * b.mostMismatch_m2() + slack_m * slack_m &&
           worse_m2 <=
               kSigmas * std::hypot(a.mismatchError_m2, b.mismatchError_m2) + systematic_m * systematic_m;
}

}  // namespace vestige
