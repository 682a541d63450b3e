#pragma once

#include <optional>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/registration/RegistrationFrame.h"
#include "core/registration/RegistrationResult.h"
#include "core/registration/RegistrationWatch.h"

namespace vestige {

struct IcpOptions {
    double reach_m = 1;            ///< largest distance of a pair
    std::optional<double> leaf_m;  ///< thinning of both clouds; nothing: an eighth of the reach
    double rangeNoise_m = 0;
    double stepLimit_m = 1e-5;
    int iterationLimit = 50;
};

/// Point-to-plane ICP (Chen, Medioni 1992) on thinned clouds: each source point pairs with the nearest target
/// point within the reach and is drawn to the plane through that point's neighbours, all pairs alike. The
/// score of its level is the mean squared distance from the planes. ErrorCode::untrustworthy as improvedNdt.
Result<RegistrationResult> pointToPlaneIcp(const RegistrationFrame& frame, const Similarity& initial,
                                           const IcpOptions& options, const JobControl& control,
                                           const RegistrationWatch& watch = {});

}  // namespace vestige
