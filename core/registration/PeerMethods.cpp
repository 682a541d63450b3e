#include "core/registration/PeerMethods.h"

#include "core/registration/OverlapQuality.h"
#include "core/registration/peers/PeerAlignment.h"

namespace vestige {

Result<RegistrationResult> peerMethod(const RegistrationFrame& frame, const Similarity& initial,
                                      const PeerMethodOptions& options, const JobControl& control) {
    constexpr std::size_t kFewestPoints = 10;
    const bool ndt = options.method == "ndt";
    const double leaf = options.leaf_m.value_or(options.voxel_m / (ndt ? 2 : 8));
    if (frame.target().size() < kFewestPoints)
        return fail(ErrorCode::untrustworthy, "the target has no surface near the source", {},
                    "give a first pose that lays the source on the target (--init)");
    const CentredSource source = frame.centred(voxelCentroids(frame.source(), leaf));
    if (source.points.size() < kFewestPoints)
        return fail(ErrorCode::untrustworthy, "the source has too few points to be registered");
    if (control.cancelled()) return fail(cancelledError());
    control.progress(0.1, "registration");

    const PeerOptions peer{options.voxel_m, options.outlierRatio, options.iterationLimit};
    const Pose start = frame.toLocal(initial.pose, source);
    const PeerOutcome outcome =
        ndt ? alignWithPclNdt(frame.target(), source.points, start, peer)
            : alignWithPclIcp(voxelCentroids(frame.target(), leaf), source.points, start, peer);
    if (control.cancelled()) return fail(cancelledError());

    RegistrationResult result;
    result.targetFromSource = {frame.toWorld(outcome.targetFromSource, source), initial.scale};
    result.converged = outcome.converged;
    result.iterations = outcome.iterations;
    result.voxelSchedule_m = {options.voxel_m};
    result.inlierDistance_m = options.voxel_m / 2 + 3 * options.rangeNoise_m;
    const VoxelGrid grid(options.voxel_m / 4);
    const std::vector<NormalDistributions> surfaces{
        NormalDistributions(gatherPoints(frame.target(), grid), grid, {})};
    setOverlap(result, surfaces, source, outcome.targetFromSource);
    return result;
}

}  // namespace vestige
