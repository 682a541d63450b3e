#pragma once

#include <vector>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/geometry/PointCloud.h"

namespace vestige {

enum class VoxelRepresentative { centroid, nearest };

/// Ratio of neighbouring voxel sizes (METHOD sections 2 and 3).
inline constexpr double kVoxelFactor = 0.8;

/// One point per non-empty voxel of the grid whose corner is the world origin (so it does not depend on the
/// cloud's own origin): the centroid, with averaged attributes (labels such as the class: the most frequent),
/// or the measured point nearest to the centroid (ties: the first), with its own. Points come out in
/// ascending order of their voxel along x, then y, then z. `size` is in the cloud's unit. ErrorCode::usage
/// when size <= 0 or the cloud spans more than 2^21 - 3 voxels along an axis.
Result<PointCloud> downsample(const PointCloud& cloud, double size,
                              VoxelRepresentative representative = VoxelRepresentative::centroid,
                              const JobControl& control = {});

/// The level asked for and its parents up to `coarsest`, each voxel size 1 / 0.8 of the one before (METHOD
/// section 2). Every level is made from the cloud itself: voxels of these sizes do not nest.
struct VoxelLevel {
    double size;
    PointCloud cloud;
};
Result<std::vector<VoxelLevel>> downsampleLevels(const PointCloud& cloud, double finest, double coarsest,
                                                 VoxelRepresentative representative,
                                                 const JobControl& control = {});

}  // namespace vestige
