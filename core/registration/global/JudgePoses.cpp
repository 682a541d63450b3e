#include "core/registration/global/JudgePoses.h"

#include <algorithm>
#include <cmath>

#include "core/base/Parallel.h"
#include "core/registration/global/PoseFit.h"

namespace vestige {
namespace {

// Lengths in voxels of the source's surfels.
constexpr double kFirstTolerance = 0.6;
constexpr double kSecondTolerance = 0.3;
constexpr double kReach = 2;
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

}  // namespace

std::vector<JudgedPose> judgePoses(std::span<const Eigen::Vector3f> target, const Surfels& source,
                                   std::span<const Eigen::Vector3f> points,
                                   std::span<const ProposedPose> proposals) {
    const double voxel = source.voxel_m;
    const SurfaceLookup surface(source, voxel);
    const SurfaceReference reference = surfaceReference(points, surface);
    const float reach = reachOf(source);
    std::vector<JudgedPose> judged(proposals.size());
    std::vector<std::vector<float>> offsets(proposals.size());
    parallelFor(proposals.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Eigen::Isometry3d pose = proposals[i].targetFromSource;
            const auto near =
                spread(pointsNear(target, pose.translation().cast<float>(), reach), kPointsToJudge);
            const auto few = spread(near, kPointsToRefine);
            const SurfaceCheck rough(few, surface, reference);
            pose = rough.refined(pose, kFirstTolerance * voxel, 6);
            pose = rough.refined(pose, kSecondTolerance * voxel, 8);
            judged[i].targetFromSource = pose;
            offsets[i] = SurfaceCheck(near, surface, reference).offsets(pose, kReach * voxel);
        }
    });
    std::size_t most = 0;
    for (const auto& one : offsets) most = std::max(most, knownOffsets(one));
    double sigma_m = kReach * voxel;
    for (const auto& one : offsets) sigma_m = std::min(sigma_m, offsetScale(one, most / 2));
    sigma_m = std::max(sigma_m, kLeastSigma * voxel);
    for (std::size_t i = 0; i < judged.size(); ++i)
        judged[i].evidence = evidenceOf(offsets[i], reference.weight, sigma_m);
    std::stable_sort(judged.begin(), judged.end(), [](const JudgedPose& a, const JudgedPose& b) {
        return a.evidence.score() > b.evidence.score();
    });
    std::vector<JudgedPose> kept;
    for (const JudgedPose& pose : judged)
        if (std::none_of(kept.begin(), kept.end(), [&](const JudgedPose& better) {
                return samePlace(pose.targetFromSource, better.targetFromSource, kSameShift * voxel);
            }))
            kept.push_back(pose);
    return kept;
}

bool rivals(const JudgedPose& other, const JudgedPose& best, double margin) {
    constexpr double kCoverage = 0.8;
    return other.evidence.agreement >= (1 - margin) * best.evidence.agreement &&
           other.evidence.coverage >= kCoverage * best.evidence.coverage;
}

}  // namespace vestige
