#pragma once

#include <optional>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/registration/RegistrationFrame.h"
#include "core/registration/RegistrationResult.h"
#include "core/registration/RegistrationWatch.h"
#include "core/registration/ndt/NormalDistributions.h"
#include "core/registration/ndt/TrustRegion.h"

namespace vestige {

struct ClassicNdtOptions {
    double voxel_m = 1;
    std::optional<double> leaf_m;  ///< thinning of the source; nothing: half the voxel
    DistributionOptions distributions;
    TrustRegionOptions limits;  ///< largestRadius_m is not looked at: a step is at most a voxel long
};

/// Classic NDT (Biber, Strasser 2003; Magnusson 2009): METHOD section 3 with one voxel size, classic cells
/// and Newton's method with a line search. ErrorCode::untrustworthy as improvedNdt.
Result<RegistrationResult> classicNdt(const RegistrationFrame& frame, const Similarity& initial,
                                      const ClassicNdtOptions& options, const JobControl& control,
                                      const RegistrationWatch& watch = {});

}  // namespace vestige
