#include "core/registration/ndt/ImprovedNdt.h"

#include <algorithm>

#include "core/registration/OverlapQuality.h"
#include "core/registration/ndt/TargetLevels.h"

namespace vestige {
namespace {

constexpr std::size_t kFewestPoints = 10;
/// A level needs no finer source than this share of its voxel (METHOD section 2: the coarser levels of the
/// thinning serve registration).
constexpr double kSourcePerVoxel = 1.0 / 8;
/// Before the last level a pose is good enough when the next step is shorter than this share of the voxel.
constexpr double kStepPerVoxel = 1.0 / 1000;
constexpr double kFirstBound = 1.0 / 4;

/// The source's points at any thinning, gathered once.
class SourceLevels {
  public:
    SourceLevels(const RegistrationFrame& frame, double leaf)
        : frame_(frame), leaf_(leaf), finest_(gatherPoints(frame.source(), VoxelGrid(leaf))) {}

    CentredSource at(double size) const {
        return frame_.centred(size > leaf_ ? means(gatherCells(finest_, VoxelGrid(size))) : means(finest_));
    }

  private:
    static std::vector<Eigen::Vector3f> means(const std::vector<CellMoments>& cells) {
        std::vector<Eigen::Vector3f> points;
        points.reserve(cells.size());
        for (const CellMoments& cell : cells) points.emplace_back(cell.mean[0], cell.mean[1], cell.mean[2]);
        return points;
    }

    const RegistrationFrame& frame_;
    double leaf_;
    std::vector<CellMoments> finest_;
};

/// One run through the levels.
class Descent {
  public:
    Descent(const RegistrationFrame& frame, const Similarity& initial, const ImprovedNdtOptions& options,
            const RegistrationWatch& watch, int levels)
        : frame_(frame), options_(options), watch_(watch), levels_(levels) {
        result_.targetFromSource = initial;
    }

    void level(const NdtScore& score, const CentredSource& source, double voxel, bool last) {
        TrustRegionOptions trustRegion = options_.trustRegion;
        trustRegion.largestRadius_m = voxel;
        trustRegion.startRadius_m = options_.trustRadius_m.value_or(kFirstBound * voxel);
        if (!last && !options_.published)
            trustRegion.stepLimit_m = std::max(trustRegion.stepLimit_m, kStepPerVoxel * voxel);
        const TrustRegionOutcome outcome = minimise([&](const Pose& pose) { return score(pose); },
                                                    frame_.toLocal(result_.targetFromSource.pose, source),
                                                    source.radius, trustRegion, observer(source, voxel));
        result_.targetFromSource.pose = frame_.toWorld(outcome.pose, source);
        result_.iterations += outcome.iterations;
        result_.voxelSchedule_m.push_back(voxel);
        result_.levels.push_back(
            {voxel, outcome.iterations, outcome.scored.score, outcome.stop, result_.targetFromSource.pose});
    }
    Pose local(const CentredSource& source) const {
        return frame_.toLocal(result_.targetFromSource.pose, source);
    }
    RegistrationResult& result() { return result_; }

  private:
    TrustRegionWatch observer(const CentredSource& source, double voxel) const {
        if (!watch_) return {};
        return [this, &source, voxel, level = static_cast<int>(result_.levels.size())](
                   const TrustRegionOutcome& best, const TrustRegionTrial& trial) {
            watch_({level,
                    levels_,
                    best.iterations,
                    voxel,
                    best.scored.score,
                    trial.bound,
                    trial.length,
                    trial.taken,
                    {frame_.toWorld(best.pose, source), result_.targetFromSource.scale}});
        };
    }

    const RegistrationFrame& frame_;
    const ImprovedNdtOptions& options_;
    const RegistrationWatch& watch_;
    int levels_;
    RegistrationResult result_;
};

}  // namespace

Result<RegistrationResult> improvedNdt(const RegistrationFrame& frame, const Similarity& initial,
                                       const ImprovedNdtOptions& options, const JobControl& control,
                                       const RegistrationWatch& watch) {
    if (frame.target().size() < kFewestPoints)
        return fail(ErrorCode::untrustworthy, "the target has no surface near the source", {},
                    "give a first pose that lays the source on the target (--init)");
    const TargetLevels levels(frame.target(), options);
    control.progress(0.4, "normal distributions");
    const double smallest = levels.smallest();
    const double leaf = options.leaf_m.value_or(options.published ? smallest / 2 : smallest);
    const SourceLevels sources(frame, leaf);
    const std::size_t count = levels.wholeLevels() + (options.published ? 0 : 1);
    Descent descent(frame, initial, options, watch, static_cast<int>(count));
    const auto advance = [&] {
        const double done = static_cast<double>(descent.result().levels.size());
        control.progress(0.4 + 0.5 * done / static_cast<double>(count), "registration");
        return !control.cancelled();
    };
    if (control.cancelled()) return fail(cancelledError());
    CentredSource source;
    for (std::size_t i = 0; i < levels.wholeLevels(); ++i) {
        const double voxel = levels.size(i);
        source = sources.at(kSourcePerVoxel * voxel);
        if (source.points.size() < kFewestPoints || !(source.radius > 0))
            return fail(ErrorCode::untrustworthy, "the source has too few points to be registered");
        descent.level(NdtScore(levels.seen(i), source), source, voxel, i + 1 == count);
        if (!advance()) return fail(cancelledError());
    }
    if (!options.published) source = sources.at(leaf);
    std::vector<NormalDistributions> surfaces = levels.surfaces(0);
    if (!options.published) {
        // How far the two scans' surfaces lie apart decides how sharp the cells are.
        const double deviation = typicalDistance(surfaceDistances(surfaces, source, descent.local(source)));
        surfaces = levels.surfaces(deviation);
        const auto shifted = levels.shiftedSurfaces(deviation);
        descent.level(NdtScore(surfaces, source, shifted), source, smallest, true);
        if (!advance()) return fail(cancelledError());
    }
    RegistrationResult& result = descent.result();
    result.notes = levels.notes();
    const StopReason stop = result.levels.back().stop;
    result.converged = stop != StopReason::iterationLimit && stop != StopReason::noOverlap;
    result.inlierDistance_m = smallest / 2 + 3 * levels.rangeNoise_m();
    setOverlap(result, surfaces, source, descent.local(source));
    return std::move(result);
}

}  // namespace vestige
