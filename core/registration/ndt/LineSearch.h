#pragma once

#include "core/registration/ndt/TrustRegion.h"

namespace vestige {

/// Minimises `score` by Newton steps, each shortened by halving until the score falls enough (Armijo;
/// Nocedal, Wright 2006, section 3.1). Where the Hessian is not positive definite its eigenvalues count by
/// magnitude. The limits are those of `options`; a first step is at most `largestRadius_m` long.
TrustRegionOutcome minimiseByLineSearch(const NdtScore& score, const Pose& start, double radius,
                                        const TrustRegionOptions& options,
                                        const TrustRegionWatch& watch = {});

}  // namespace vestige
