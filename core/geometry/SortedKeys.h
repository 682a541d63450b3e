#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "core/base/LargeArray.h"

namespace vestige {

/// Packed: of a hundred million, four bytes each are half a gigabyte.
template <class Key>
struct [[gnu::packed, gnu::aligned(4)]] KeyedIndex {
    Key key;
    std::uint32_t index;
};

/// Fills `keys` with the keys of the items begin, begin + 1, ...; called from many threads.
template <class Key>
using KeysOf = std::function<void(std::size_t begin, std::span<Key> keys)>;

/// The items 0 ... count - 1 in ascending order of (key, index), for keys below 2^keyBits: the one sort
/// behind Morton order and voxel grids. A radix sort from the highest digit down, each digit's buckets in
/// parallel; the same result for any number of threads. `keysOf` is asked twice for every item, so that no
/// array of unsorted keys has to be held. Key is std::uint32_t or std::uint64_t.
template <class Key>
LargeArray<KeyedIndex<Key>> sortedByKey(std::size_t count, unsigned keyBits, const KeysOf<Key>& keysOf);

extern template LargeArray<KeyedIndex<std::uint32_t>> sortedByKey(std::size_t, unsigned,
                                                                  const KeysOf<std::uint32_t>&);
extern template LargeArray<KeyedIndex<std::uint64_t>> sortedByKey(std::size_t, unsigned,
                                                                  const KeysOf<std::uint64_t>&);

}  // namespace vestige
