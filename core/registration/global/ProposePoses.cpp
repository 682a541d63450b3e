#include "core/registration/global/ProposePoses.h"

#include <algorithm>

#include "core/base/Parallel.h"
#include "core/base/Result.h"
#include "core/registration/global/ConsistentMatches.h"
#include "core/registration/global/FeatureMatches.h"
#include "core/registration/global/PoseFit.h"
#include "core/registration/global/SurfaceLookup.h"
#include "core/registration/global/SurfelFeatures.h"

namespace vestige {
namespace {

// Lengths in voxels of the search.
constexpr double kFeatureRadius = 5;
constexpr double kMatchTolerance = 1.5;
constexpr double kMatchDistance = 3;
constexpr double kLookupCell = 2.5;

constexpr double kLeastBend = 0.03;  // mean squared sine of the normals' turn
constexpr double kTargetBend = 0.6;  // of the source's: the target must not lack what the source has
constexpr std::size_t kSourceFeatures = 2500;
constexpr std::size_t kTargetFeatures = 60000;
constexpr std::size_t kMatches = 6000;
constexpr std::size_t kMostMatchesPerFeature = 6;
constexpr std::size_t kProposals = 200;
constexpr std::size_t kFitSurfels = 1200;

constexpr double kCosineOfTenDegrees = 0.98480775301220802;

void stopIfCancelled(const JobControl& control) {
    if (control.cancelled()) throw ErrorException{cancelledError()};
}

}  // namespace

bool samePlace(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, double shift_m) {
    const double cosine = ((a.linear().transpose() * b.linear()).trace() - 1) / 2;
    return (a.translation() - b.translation()).norm() < shift_m && cosine > kCosineOfTenDegrees;
}

void keepDistinct(std::vector<ProposedPose>& poses, double shift_m) {
    std::stable_sort(poses.begin(), poses.end(),
                     [](const ProposedPose& a, const ProposedPose& b) { return a.score > b.score; });
    std::vector<ProposedPose> kept;
    for (const ProposedPose& pose : poses)
        if (std::none_of(kept.begin(), kept.end(), [&](const ProposedPose& better) {
                return samePlace(pose.targetFromSource, better.targetFromSource, shift_m);
            }))
            kept.push_back(pose);
    poses = std::move(kept);
}

std::vector<ProposedPose> proposePoses(const Surfels& target, const Surfels& source, std::size_t count,
                                       const JobControl& control) {
    const double voxel = source.voxel_m;
    const double radius = kFeatureRadius * voxel;
    const SurfelFeatures sourceFeatures = featuresOf(source, radius, kLeastBend, kSourceFeatures);
    const SurfelFeatures targetFeatures =
        featuresOf(target, radius, kTargetBend * kLeastBend, kTargetFeatures);
    stopIfCancelled(control);
    control.progress(0.6, "shapes that look alike");
    const auto matches = matchFeatures(
        targetFeatures, sourceFeatures,
        std::clamp<std::size_t>(kMatches / std::max<std::size_t>(1, sourceFeatures.surfel.size()), 2,
                                kMostMatchesPerFeature));
    const auto proposals = consistentPoses(target, source, matches,
                                           {kMatchTolerance * voxel, kMatchDistance * voxel, kProposals});
    stopIfCancelled(control);
    control.progress(0.8, "poses that agree");

    const SurfaceLookup surface(target, kLookupCell * voxel);
    const Surfels few = source.select(spreadIndices(source.size(), kFitSurfels));
    const PoseFit fit(few, directionWeights(few));
    std::vector<ProposedPose> poses(proposals.size());
    const auto improve = [&](double tolerance_m, int steps, double scoredWith_m) {
        parallelFor(poses.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                poses[i].targetFromSource =
                    fit.refined(surface, poses[i].targetFromSource, tolerance_m, steps);
                poses[i].score = fit.score(surface, poses[i].targetFromSource, scoredWith_m);
            }
        });
    };
    for (std::size_t i = 0; i < poses.size(); ++i) poses[i].targetFromSource = proposals[i].targetFromSource;
    improve(3 * voxel, 4, 2 * voxel);
    keepDistinct(poses, 2 * voxel);
    if (poses.size() > 3 * count) poses.resize(3 * count);
    improve(2 * voxel, 10, voxel);
    improve(voxel, 10, voxel);
    keepDistinct(poses, 3 * voxel);
    if (poses.size() > count) poses.resize(count);
    control.progress(1, "poses that agree");
    return poses;
}

}  // namespace vestige
