#include "core/registration/ndt/ImprovedNdt.h"

#include <algorithm>

#include "core/base/Numbers.h"
#include "core/registration/OverlapQuality.h"
#include "core/registration/ndt/VoxelSchedule.h"

namespace vestige {
namespace {

constexpr std::size_t kFewestPoints = 10;
/// A level needs no finer source than this share of its voxel (METHOD section 2: the coarser levels of the
/// thinning serve registration).
constexpr double kSourcePerVoxel = 1.0 / 8;

struct Levels {
    std::vector<NormalDistributions> cells;  ///< from v0 to v_n
    std::vector<std::string> notes;
};

/// Steps 1 and 2: the target's distributions at each size of the schedule, v_n chosen where it is not given.
Levels buildLevels(const MomentPyramid& pyramid, std::size_t targetPoints,
                   const ImprovedNdtOptions& options) {
    Levels levels;
    std::vector<FlatnessCount> counts;
    const double finest = options.voxel_m.value_or(options.voxelFloor_m);
    for (const double size : voxelSchedule(std::max(options.voxelStart_m, finest), finest)) {
        const VoxelGrid grid(size);
        levels.cells.emplace_back(pyramid.at(grid), grid, options.distributions);
        counts.push_back(levels.cells.back().flatness());
        if (!options.voxel_m && pastHalfOfPoints(counts, targetPoints)) break;
    }
    if (options.voxel_m) return levels;
    const std::size_t chosen = finestByFlatness(counts, targetPoints, options.voxelCeiling_m);
    levels.cells.erase(levels.cells.begin() + static_cast<std::ptrdiff_t>(chosen) + 1, levels.cells.end());
    levels.notes.push_back("Smallest voxel " + fixedText(counts[chosen].voxel_m, 3) + " m, where " +
                           fixedText(100 * counts[chosen].ratio(), 0) + " % of the target's cells are flat");
    return levels;
}

/// Copies of the last level's grid, shifted along the diagonal.
std::vector<NormalDistributions> shiftedLevels(const MomentPyramid& pyramid, double size,
                                               const ImprovedNdtOptions& options) {
    std::vector<NormalDistributions> shifted;
    for (int i = 1; i < options.shiftedGrids; ++i) {
        const VoxelGrid grid(size, size * i / options.shiftedGrids);
        shifted.emplace_back(pyramid.at(grid), grid, options.distributions);
    }
    return shifted;
}

/// Mean of the score over a grid and its shifted copies.
ScoredPose meanScore(const NdtScore& score, const std::vector<NormalDistributions>& shifted,
                     const Pose& pose) {
    ScoredPose mean = score(pose);
    for (const NormalDistributions& grid : shifted) {
        const ScoredPose other = score.withFinest(grid)(pose);
        mean.score += other.score;
        mean.gradient += other.gradient;
        mean.hessian += other.hessian;
        mean.inside = std::max(mean.inside, other.inside);
    }
    const double share = 1 / static_cast<double>(shifted.size() + 1);
    mean.score *= share;
    mean.gradient *= share;
    mean.hessian *= share;
    return mean;
}

}  // namespace

Result<RegistrationResult> improvedNdt(const RegistrationFrame& frame, const Similarity& initial,
                                       const ImprovedNdtOptions& given, const JobControl& control,
                                       const RegistrationWatch& watch) {
    ImprovedNdtOptions options = given;
    if (frame.target().size() < kFewestPoints)
        return fail(ErrorCode::untrustworthy, "the target has no surface near the source", {},
                    "give a first pose that lays the source on the target (--init)");
    const double finest = options.voxel_m.value_or(options.voxelFloor_m);
    const MomentPyramid pyramid(frame.target(), finest, std::max(options.voxelStart_m, finest));
    if (options.estimateNoise)
        options.distributions.rangeNoise_m = surfaceThickness(pyramid.at(VoxelGrid(options.voxelStart_m)));
    const Levels levels = buildLevels(pyramid, frame.target().size(), options);
    control.progress(0.4, "normal distributions");

    const double smallest = levels.cells.back().grid().size();
    const double leaf = options.leaf_m.value_or(smallest / 2);
    const std::vector<Eigen::Vector3f> finestSource = voxelCentroids(frame.source(), leaf);
    RegistrationResult result;
    result.notes = levels.notes;
    if (options.estimateNoise)
        result.notes.push_back("Range noise of the target taken as " +
                               fixedText(1000 * options.distributions.rangeNoise_m, 1) + " mm");
    result.targetFromSource = initial;
    CentredSource source;
    for (std::size_t i = 0; i < levels.cells.size(); ++i) {
        if (control.cancelled()) return fail(cancelledError());
        const double voxel = levels.cells[i].grid().size();
        const double thinning = kSourcePerVoxel * voxel;
        source = frame.centred(thinning > leaf ? voxelCentroids(finestSource, thinning) : finestSource);
        if (source.points.size() < kFewestPoints || !(source.radius > 0))
            return fail(ErrorCode::untrustworthy, "the source has too few points to be registered");
        const auto cells = std::span(levels.cells).first(i + 1);
        TrustRegionOptions trustRegion = options.trustRegion;
        trustRegion.largestRadius_m = voxel;
        const bool last = i + 1 == levels.cells.size();
        const auto shifted =
            last ? shiftedLevels(pyramid, voxel, options) : std::vector<NormalDistributions>{};
        const NdtScore score(options.coarserCells ? cells : cells.last(1), source);
        TrustRegionWatch observe;
        if (watch)
            observe = [&](const TrustRegionOutcome& best, const TrustRegionTrial& trial) {
                watch({static_cast<int>(i),
                       static_cast<int>(levels.cells.size()),
                       best.iterations,
                       voxel,
                       best.scored.score,
                       trial.bound,
                       trial.length,
                       trial.taken,
                       {frame.toWorld(best.pose, source), initial.scale}});
            };
        const TrustRegionOutcome outcome = minimise(
            [&](const Pose& pose) { return meanScore(score, shifted, pose); },
            frame.toLocal(result.targetFromSource.pose, source), source.radius, trustRegion, observe);
        result.targetFromSource.pose = frame.toWorld(outcome.pose, source);
        result.iterations += outcome.iterations;
        result.voxelSchedule_m.push_back(voxel);
        result.levels.push_back(
            {voxel, outcome.iterations, outcome.scored.score, outcome.stop, result.targetFromSource.pose});
        control.progress(0.4 + 0.5 * static_cast<double>(i + 1) / static_cast<double>(levels.cells.size()),
                         "registration");
    }
    const StopReason stop = result.levels.back().stop;
    result.converged = stop != StopReason::iterationLimit && stop != StopReason::noOverlap;
    result.inlierDistance_m = smallest / 2 + 3 * options.distributions.rangeNoise_m;
    const OverlapQuality quality =
        overlapQuality(pyramid.finerThan(result.inlierDistance_m / 4), source,
                       frame.toLocal(result.targetFromSource.pose, source), result.inlierDistance_m);
    result.overlap = quality.sourceShare;
    result.targetOverlap = quality.targetShare;
    result.rmse_m = quality.rmse_m;
    return result;
}

}  // namespace vestige
