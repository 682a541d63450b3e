#include "core/registration/Descent.h"

namespace vestige {

Status checkTarget(const RegistrationFrame& frame, double cell_m) {
    if (frame.extent_m() >= cell_m * static_cast<double>(VoxelGrid::kHalf - 1))
        return fail(ErrorCode::usage, "cells this small cannot be counted across clouds this large", {},
                    "a larger voxel or leaf is needed");
    if (frame.target().size() >= kFewestPoints) return {};
    return fail(ErrorCode::untrustworthy, "the target has no surface near the source", {},
                "give a first pose that lays the source on the target (--init)");
}

Status checkSource(const CentredSource& source) {
    if (source.points.size() >= kFewestPoints && source.radius > 0) return {};
    return fail(ErrorCode::untrustworthy, "the source has too few points to be registered");
}

Descent::Descent(const RegistrationFrame& frame, const Similarity& initial, const RegistrationWatch& watch,
                 int levels)
    : frame_(frame), watch_(watch), levels_(levels) {
    result_.targetFromSource = initial;
}

Pose Descent::local(const CentredSource& source) const {
    return frame_.toLocal(result_.targetFromSource.pose, source);
}

TrustRegionWatch Descent::observer(const CentredSource& source, double voxel) const {
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

void Descent::record(const TrustRegionOutcome& outcome, const CentredSource& source, double voxel) {
    result_.targetFromSource.pose = frame_.toWorld(outcome.pose, source);
    result_.iterations += outcome.iterations;
    result_.converged = outcome.stop != StopReason::iterationLimit && outcome.stop != StopReason::noOverlap;
    result_.voxelSchedule_m.push_back(voxel);
    result_.levels.push_back(
        {voxel, outcome.iterations, outcome.scored.score, outcome.stop, result_.targetFromSource.pose});
}

}  // namespace vestige
