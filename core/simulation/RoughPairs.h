#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/base/Result.h"
#include "core/simulation/HandheldScanner.h"

namespace vestige {

/// One pair of places that an analyst took for the same: target (world metres), source (the layer's own).
struct RoughPair {
    Eigen::Vector3d target;
    Eigen::Vector3d source;
};

/// Up to six pairs spread over the scan, at places that the aerial cloud shows too (`aerialCounts`: echoes
/// near each place of scan.sample), with errors of 20 mm on the target and 2 mm on the source, one sigma per
/// axis. ErrorCode::input when fewer than four places are shared.
Result<std::vector<RoughPair>> roughPairs(const HandheldScan& scan,
                                          const std::vector<std::uint32_t>& aerialCounts,
                                          const Eigen::Vector3d& worldFromSite, const std::string& layer,
                                          std::uint64_t seed);

}  // namespace vestige
