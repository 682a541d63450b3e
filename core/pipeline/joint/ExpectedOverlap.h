#pragma once

#include "core/geometry/PointCloud.h"

namespace vestige {

/// How much of the smaller of two placed clouds has the other one near: the share of its occupied voxels
/// (edge 1/24 of its extent) of which the voxel or one that touches it holds points of the other. The larger
/// of the two shares where they differ in size. Points of huge clouds are sampled evenly in their order.
double expectedOverlap(const PointCloud& a, const Similarity& sceneFromA, const PointCloud& b,
                       const Similarity& sceneFromB);

}  // namespace vestige
