#include "core/registration/ndt/ClassicNdt.h"

#include <algorithm>

#include "core/registration/Descent.h"
#include "core/registration/OverlapQuality.h"
#include "core/registration/SourceLevels.h"
#include "core/registration/ndt/LineSearch.h"

namespace vestige {

Result<RegistrationResult> classicNdt(const RegistrationFrame& frame, const Similarity& initial,
                                      const ClassicNdtOptions& options, const JobControl& control,
                                      const RegistrationWatch& watch) {
    if (Status status =
            checkTarget(frame, std::min(options.voxel_m, options.leaf_m.value_or(options.voxel_m / 2)));
        !status)
        return fail(status.error());
    const double voxel = options.voxel_m;
    const CentredSource source = SourceLevels(frame, options.leaf_m.value_or(voxel / 2)).at(0);
    if (Status status = checkSource(source); !status) return fail(status.error());
    if (control.cancelled()) return fail(cancelledError());
    DistributionOptions cells = options.distributions;
    cells.flatCellsInPlane = true;
    const VoxelGrid grid(voxel);
    const std::vector<NormalDistributions> target{
        NormalDistributions(gatherPoints(frame.target(), grid), grid, cells)};
    control.progress(0.3, "registration");
    TrustRegionOptions limits = options.limits;
    limits.largestRadius_m = voxel;
    Descent descent(frame, initial, watch, 1);
    descent.record(minimiseByLineSearch(NdtScore(target, source), descent.local(source), source.radius,
                                        limits, descent.observer(source, voxel)),
                   source, voxel);
    if (control.cancelled()) return fail(cancelledError());
    RegistrationResult& result = descent.result();
    result.inlierDistance_m = voxel / 2 + 3 * options.distributions.rangeNoise_m;
    setOverlap(result, target, source, descent.local(source));
    return std::move(result);
}

}  // namespace vestige
