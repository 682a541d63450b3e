#pragma once

#include <functional>
#include <span>
#include <string>

#include "core/base/JobControl.h"
#include "core/geometry/PointCloud.h"

namespace vestige {

/// The points of one cell of a grid, and those of its 27 neighbouring cells (itself included), among which
/// are all within the search radius of each of them. Coordinates are relative to the cell's corner, in the
/// cloud's unit: exact to a float's last bit of the radius, wherever the cloud lies.
struct NearbyPoints {
    static constexpr std::size_t kLanes = 4;

    /// Of all nearby points, in a fixed order; filled up to a multiple of kLanes with points far away.
    std::span<const float> x;
    std::span<const float> y;
    std::span<const float> z;
    std::size_t count = 0;  ///< without the filling
    /// The cell's own points: indices into the cloud; the first is nearby point `firstOwn`, and so on.
    std::span<const std::uint32_t> own;
    std::size_t firstOwn = 0;
};

/// Calls `use` for every occupied cell of a grid of cells no smaller than `radius` (cloud's unit), many
/// threads at once; every point is an own point exactly once. Progress is reported as `step`. Throws
/// ErrorException when the job is cancelled.
void forNearbyPoints(const PointCloud& cloud, double radius, const std::string& step,
                     const JobControl& control, const std::function<void(const NearbyPoints&)>& use);

}  // namespace vestige
