#pragma once

#include <functional>
#include <span>
#include <string>

#include "core/base/JobControl.h"
#include "core/geometry/PointCloud.h"

namespace vestige {

/// Some points that lie together (those of one cell of a grid) and the points near them, themselves included,
/// among which are all within the search radius of each. Coordinates are relative to a place close by, in
/// the cloud's unit: exact to a float's last bit of the radius, wherever the cloud lies.
struct NearbyPoints {
    static constexpr std::size_t kLanes = 4;
    static constexpr std::size_t filled(std::size_t count) { return (count + kLanes - 1) / kLanes * kLanes; }

    /// Of all nearby points, in a fixed order; filled up to a multiple of kLanes with points far away.
    std::span<const float> x;
    std::span<const float> y;
    std::span<const float> z;
    std::size_t count = 0;  ///< without the filling
    /// The own points: indices into the cloud; the first is nearby point `firstOwn`, and so on.
    std::span<const std::uint32_t> own;
    std::size_t firstOwn = 0;

    /// Whether two own points lie at the same place.
    bool coincide(std::size_t a, std::size_t b) const {
        a += firstOwn;
        b += firstOwn;
        return x[a] == x[b] && y[a] == y[b] && z[a] == z[b];
    }
};

/// Calls `use`, many threads at once, until every point of the cloud has been an own point exactly once.
/// `radius` in the cloud's unit. Progress is reported as `step`. Throws
/// ErrorException when the job is cancelled.
void forNearbyPoints(const PointCloud& cloud, double radius, const std::string& step,
                     const JobControl& control, const std::function<void(const NearbyPoints&)>& use);

}  // namespace vestige
