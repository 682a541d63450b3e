#pragma once

#include <optional>
#include <string>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/registration/RegistrationFrame.h"
#include "core/registration/RegistrationResult.h"

namespace vestige {

struct PeerMethodOptions {
    std::string method;  ///< "ndt" or "icp"
    double voxel_m = 1;
    std::optional<double> leaf_m;  ///< nothing: half the voxel for NDT, an eighth for ICP
    std::optional<double> outlierRatio;
    double rangeNoise_m = 0;
    int iterationLimit = 50;
};

/// Classic NDT or ICP as PCL has them, with the same frame, thinning and figures of quality as improved NDT.
Result<RegistrationResult> peerMethod(const RegistrationFrame& frame, const Similarity& initial,
                                      const PeerMethodOptions& options, const JobControl& control);

}  // namespace vestige
