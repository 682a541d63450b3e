#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/JobControl.h"
#include "core/filters/CellLayout.h"
#include "core/filters/CellMembers.h"
#include "core/filters/PlacedPoints.h"

namespace vestige {

/// What is wanted besides the means.
enum class VoxelWants { means, members, nearest };

/// The occupied cells of a grid in ascending order along x, then y, then z.
struct VoxelMeans {
    LargeArray<Eigen::Vector3f> offsets;    ///< mean of each cell's points, from the points' origin
    LargeArray<Eigen::Vector3f> residuals;  ///< where offsets may be too far for a float, else empty
    CellMembers members;                    ///< VoxelWants::members: which points
    std::vector<std::uint32_t> nearest;  ///< VoxelWants::nearest: the point nearest the mean, ties the first
};

/// Points are dealt into buckets of cells, then summed bucket by bucket in fixed point: exact to 2^-30 of a
/// cell each, so neither order nor threads change a bit. `layout` has at most CellBuckets::covers cells.
/// Throws ErrorException when the job is cancelled.
VoxelMeans voxelMeans(const CellLayout& layout, const PointSpan& points, VoxelWants wants,
                      const JobControl& control);

}  // namespace vestige
