#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "core/geometry/NeighbourIndex.h"

namespace vestige {

/// The distances from up to eight points of an index to their nearest points, each point's own among them.
struct NearestDistances {
    std::span<const std::uint32_t> points;  ///< indices into the points of the index
    /// squared[j][lane]: from points[lane] to its j-th nearest, ascending in j, infinite where the index has
    /// no more points; the lanes beyond points.size() mean nothing.
    std::span<const std::array<float, 8>> squared;
};

/// Calls `use`, many threads at once, until every point of the index has had its `count` > 0 nearest. All
/// points of a leaf are asked for together, eight at a time: several times as fast as one by one. `done` is
/// told now and then how many more points have had theirs; what it throws leaves the loop.
void forNearestDistances(const NeighbourIndex& index, std::size_t count,
                         const std::function<void(const NearestDistances&)>& use,
                         const std::function<void(std::size_t points)>& done = {});

/// The same with the neighbours themselves, nearest first, ties by index: use(point, neighbours).
void forNearest(
    const NeighbourIndex& index, std::size_t count,
    const std::function<void(std::uint32_t point, std::span<const NeighbourIndex::Neighbour>)>& use,
    const std::function<void(std::size_t points)>& done = {});

}  // namespace vestige
