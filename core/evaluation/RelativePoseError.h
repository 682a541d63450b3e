#pragma once

#include <span>

#include "core/base/Result.h"
#include "core/geometry/Pose.h"

namespace vestige {

/// METHOD section 4.
struct RelativePoseError {
    std::size_t pairs = 0;
    double translation_m = 0;  ///< sqrt(mean |trans(E_i)|^2)
    double rotation_rad = 0;   ///< sqrt(mean angle(E_i)^2)
};

/// E_i = (Q_i^-1 Q_{i+D})^-1 (P_i^-1 P_{i+D}) over a sequence of estimates P and truth Q, worldFromScanner.
/// ErrorCode::input when the sequences differ in length or have no pair at this distance.
Result<RelativePoseError> relativePoseError(std::span<const Pose> estimates, std::span<const Pose> truth,
                                            std::size_t distance = 1);

}  // namespace vestige
