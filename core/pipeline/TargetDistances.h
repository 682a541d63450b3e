#pragma once

#include <vector>

#include "core/geometry/Octree.h"

namespace vestige {

/// For every point of `source` its distance in metres to the target there: to the plane through the target's
/// 8 nearest points where these make one (smallest spread below a tenth of the middle one) and lie around the
/// foot, else to the nearest point. Bit-identical for any thread count.
std::vector<float> targetDistances(const Octree& target, const Similarity& worldFromTarget,
                                   const PointCloud& source, const Similarity& worldFromSource);

}  // namespace vestige
