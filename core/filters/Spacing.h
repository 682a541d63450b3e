#pragma once

#include "core/base/Result.h"
#include "core/geometry/Octree.h"

namespace vestige {

/// Search radii that filters accept, in the cloud's unit.
inline constexpr double kLeastRadius = 1e-9;
inline constexpr double kMostRadius = 1e9;

/// ErrorCode::usage unless `radius` is 0 (automatic) or from kLeastRadius to kMostRadius.
Status checkRadius(double radius);

/// Median of the local spacing (Octree::localSpacing) of at most 10 000 points spread evenly over the cloud's
/// order, in the cloud's unit; 0 for fewer than two points.
double medianSpacing(const Octree& octree);

/// 3 times the median spacing: on a surface, about 30 neighbours. Builds an octree for it.
double automaticRadius(const PointCloud& cloud);

}  // namespace vestige
