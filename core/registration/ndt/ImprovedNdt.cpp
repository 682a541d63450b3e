#include "core/registration/ndt/ImprovedNdt.h"

#include <algorithm>
#include <memory>

#include "core/registration/Descent.h"
#include "core/registration/OverlapQuality.h"
#include "core/registration/SourceLevels.h"
#include "core/registration/ndt/StartFan.h"
#include "core/registration/ndt/TargetLevels.h"

namespace vestige {
namespace {

/// A level needs no finer source than this share of its voxel (METHOD section 2: the coarser levels of the
/// thinning serve registration).
constexpr double kSourcePerVoxel = 1.0 / 8;
/// The thinning that a sparse source may get, against v0.
constexpr double kLargestLeaf = 1.0 / 8;
/// Before the last level a pose is good enough when the next step is shorter than this share of the voxel.
constexpr double kStepPerVoxel = 1.0 / 1000;
/// In the last one steps that are short against the distance that the scans lie apart only chase points over
/// the faces of cells.
constexpr double kStepPerDistance = 1.0 / 100;
constexpr double kFirstBound = 1.0 / 4;
/// The first pass over surfaces: its smallest cell against v_n, its least thickness against the whole cells.
constexpr double kMiddle = 4;
constexpr double kReach = 1.0 / 32;
constexpr double kFanThinning = 1.0 / 4;
constexpr double kInlierPerStart = 1.0 / 32;

TrustRegionOptions limitsOf(const ImprovedNdtOptions& options, double voxel, bool last) {
    TrustRegionOptions limits = options.trustRegion;
    limits.largestRadius_m = voxel;
    limits.startRadius_m = options.trustRadius_m.value_or(kFirstBound * voxel);
    if (!last && !options.published) limits.stepLimit_m = std::max(limits.stepLimit_m, kStepPerVoxel * voxel);
    return limits;
}

}  // namespace

Result<RegistrationResult> improvedNdt(const RegistrationFrame& frame, const Similarity& initial,
                                       const ImprovedNdtOptions& options, const JobControl& control,
                                       const RegistrationWatch& watch) {
    const double cell = TargetLevels::finestCell(options);
    if (Status status = checkTarget(frame, std::min(cell, options.leaf_m.value_or(cell))); !status)
        return fail(status.error());
    const TargetLevels levels(frame.target(), options);
    control.progress(0.4, "normal distributions");
    const double smallest = levels.smallest();
    const double leaf = options.leaf_m.value_or(options.published ? smallest / 2 : smallest);
    const bool leafIsFree = !options.leaf_m && !options.published;
    const SourceLevels sources(frame, leaf, leafIsFree ? kLargestLeaf * levels.size(0) : leaf);
    const std::size_t count = levels.wholeLevels() + (options.published           ? 0
                                                      : options.shiftedGrids == 1 ? 2
                                                                                  : 1);
    auto descent = std::make_unique<Descent>(frame, initial, watch, static_cast<int>(count));
    const auto advance = [&] {
        const double done = static_cast<double>(descent->result().levels.size());
        control.progress(0.4 + 0.5 * done / static_cast<double>(count), "registration");
        return !control.cancelled();
    };
    if (control.cancelled()) return fail(cancelledError());
    CentredSource source;
    double leastStep = 0;
    const auto level = [&](const NdtScore& score, double voxel, bool last) {
        TrustRegionOptions limits = limitsOf(options, voxel, last);
        limits.stepLimit_m = std::max(limits.stepLimit_m, leastStep);
        NdtScore::Memory memory;
        descent->record(
            minimise([&](const Pose& pose) { return score(pose, &memory); }, descent->local(source),
                     source.radius, limits, descent->observer(source, voxel)),
            source, voxel);
    };
    const auto descend = [&]() -> Status {
        for (std::size_t i = 0; i < levels.wholeLevels(); ++i) {
            const double voxel = levels.size(i);
            source = sources.at(kSourcePerVoxel * voxel);
            if (Status status = checkSource(source); !status) return status;
            level(NdtScore(levels.seen(i), source), voxel, i + 1 == count);
            if (!advance()) return fail(cancelledError());
        }
        return {};
    };
    if (Status status = descend(); !status) return fail(status.error());
    if (options.startFan && explainsTooLittle(levels, source, descent->local(source))) {
        const CentredSource coarse = sources.at(kFanThinning * levels.size(0));
        const auto starts = startFan(levels, coarse, frame.toLocal(initial.pose, coarse),
                                     limitsOf(options, levels.size(0), false));
        // Scans that overlap little explain little at the right pose, too: only one that explains enough
        // counts.
        const RegistrationWatch nobody;
        std::unique_ptr<Descent> best = std::move(descent);
        double bestScore = 0;
        for (const Pose& start : starts) {
            descent =
                std::make_unique<Descent>(frame, Similarity{frame.toWorld(start, coarse), initial.scale},
                                          nobody, static_cast<int>(count));
            if (Status status = descend(); !status) return fail(status.error());
            const double score = descent->result().levels.back().score;
            if (score >= bestScore || explainsTooLittle(levels, source, descent->local(source))) continue;
            bestScore = score;
            best = std::make_unique<Descent>(frame, descent->result().targetFromSource, watch,
                                             static_cast<int>(count));
            best->result() = descent->result();
        }
        descent = std::move(best);
    }
    if (!options.published) source = sources.at(leaf);
    std::vector<NormalDistributions> surfaces;
    if (!options.published) {
        // What few surfaces hold may still be a whole level's error away: cells as thin as the scans lie
        // apart would not reach that far.
        const double middle = std::max(smallest, std::min(kMiddle * smallest, levels.largestSurface()));
        const double whole = levels.size(levels.wholeLevels() - 1);
        surfaces = levels.surfaces(kReach * whole, middle);
        level(NdtScore(surfaces, source), middle, false);
        const std::vector<float> distances = surfaceDistances(surfaces, source, descent->local(source));
        const double deviation = typicalDistance(distances);
        leastStep = kStepPerDistance * deviation;
        surfaces = levels.surfaces(deviation, smallest);
        const auto shifted = levels.shiftedSurfaces(deviation);
        level(NdtScore(surfaces, source, shifted), smallest, true);
        if (!advance()) return fail(cancelledError());
    }
    RegistrationResult& result = descent->result();
    result.notes = levels.notes();
    if (!options.published) source = sources.at(leaf);
    // To lie on the target a point needs no flat cell.
    const auto whole = levels.seen(levels.wholeLevels() - 1);
    std::vector<NormalDistributions> explaining(whole.begin(), whole.end());
    explaining.insert(explaining.end(), surfaces.begin(), surfaces.end());
    double inlier = smallest / 2;
    if (!options.published) inlier = std::max(inlier, kInlierPerStart * options.voxelStart_m);
    result.inlierDistance_m = inlier + 3 * levels.rangeNoise_m();
    setOverlap(result, explaining, source, descent->local(source));
    return std::move(result);
}

}  // namespace vestige
