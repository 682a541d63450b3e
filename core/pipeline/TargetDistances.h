#pragma once

#include <vector>

#include "core/base/JobControl.h"
#include "core/geometry/Octree.h"

namespace vestige {

/// For every point of `source` its signed distance in metres to the target's surface there: to the plane
/// through the target's points round the foot, 12 of them or, where noise hides it, up to 192; NaN where they
/// make no plane or do not lie around the foot: there is no surface of the target to compare with.
/// Neighbouring source points, within half the target's spacing, share one plane.
///
/// Positive is above the target's surface or, where that is upright, outside: further than it from the
/// vertical through the source's middle. Empty when cancelled. Bit-identical for any thread count.
std::vector<float> targetDistances(const Octree& target, const Similarity& worldFromTarget,
                                   const PointCloud& source, const Similarity& worldFromSource,
                                   const JobControl& control = {});

}  // namespace vestige
