#pragma once

#include <span>

#include "core/registration/ndt/CellMoments.h"
#include "core/registration/ndt/NdtScore.h"

namespace vestige {

/// How well a registered source lies on its target.
struct OverlapQuality {
    double sourceShare = 0;  ///< of the source's points that are inliers
    double targetShare = 0;  ///< of the target's voxels (edge: the inlier distance) that hold an inlier
    double rmse_m = 0;       ///< of the inliers' distances
};

/// A source point is an inlier when a target point is within `inlierDistance_m`; `target` are voxel centroids
/// much finer than that. Its distance counts from the plane through the target points within that distance
/// where they span one, but never more than to the nearest of them. `pose` maps the centred source into the
/// target's frame.
OverlapQuality overlapQuality(std::span<const CellMoments> target, const CentredSource& source,
                              const Pose& pose, double inlierDistance_m);

}  // namespace vestige
