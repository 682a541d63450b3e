#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace vestige {

struct KeyedIndex {
    std::uint64_t key;
    std::uint32_t index;
};

/// The items 0 ... count - 1 in ascending order of (key, index): the one sort behind Morton order and voxel
/// grids. `keysOf(begin, keys)` fills keys with those of the items begin, begin + 1, ...; it is called from
/// many threads and three times for every item, so that no array of unsorted keys has to be held. 16 bytes an
/// item, O(n log n), the same result for any number of threads.
std::vector<KeyedIndex> sortedByKey(
    std::size_t count, const std::function<void(std::size_t begin, std::span<std::uint64_t> keys)>& keysOf);

}  // namespace vestige
