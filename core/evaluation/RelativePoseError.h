#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/Result.h"
#include "core/geometry/Pose.h"

namespace vestige {

/// How far one relative pose is off: |trans(E_i)| and the angle of E_i.
struct PoseDifference {
    double translation_m = 0;
    double rotation_rad = 0;
};

/// METHOD section 4.
struct RelativePoseError {
    std::size_t pairs = 0;
    double translation_m = 0;  ///< sqrt(mean |trans(E_i)|^2)
    double rotation_rad = 0;   ///< sqrt(mean angle(E_i)^2)
    PoseDifference median;     ///< of each by itself; the mean of the middle two for an even number
    PoseDifference largest;
    std::vector<PoseDifference> each;  ///< E_0, E_1, ...
};

/// E_i = (Q_i^-1 Q_{i+D})^-1 (P_i^-1 P_{i+D}) over a sequence of estimates P and truth Q, worldFromScanner.
/// ErrorCode::input when the sequences differ in length or have no pair at this distance.
Result<RelativePoseError> relativePoseError(std::span<const Pose> estimates, std::span<const Pose> truth,
                                            std::size_t distance = 1);

}  // namespace vestige
