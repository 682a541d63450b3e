#include "core/geometry/SortedKeys.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "core/base/Parallel.h"

namespace vestige {
namespace {

constexpr std::size_t kGrain = 65536;
constexpr unsigned kBucketBits = 12;
constexpr std::size_t kBuckets = std::size_t{1} << kBucketBits;
constexpr std::size_t kBlock = 1024;

struct Range {
    std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t most = 0;
};

using KeysOf = std::function<void(std::size_t, std::span<std::uint64_t>)>;

/// Calls use(index, key) for every item of [begin, end), in order.
template <class Use>
void eachKey(const KeysOf& keysOf, std::size_t begin, std::size_t end, const Use& use) {
    std::array<std::uint64_t, kBlock> keys;
    for (std::size_t at = begin; at < end; at += kBlock) {
        const std::size_t many = std::min(kBlock, end - at);
        keysOf(at, std::span(keys).first(many));
        for (std::size_t i = 0; i < many; ++i) use(at + i, keys[i]);
    }
}

}  // namespace

std::vector<KeyedIndex> sortedByKey(std::size_t count, const KeysOf& keysOf) {
    const std::size_t chunks = (count + kGrain - 1) / kGrain;
    std::vector<Range> ranges(chunks);
    parallelChunks(count, kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        Range range;
        eachKey(keysOf, begin, end, [&](std::size_t, std::uint64_t key) {
            range.least = std::min(range.least, key);
            range.most = std::max(range.most, key);
        });
        ranges[chunk] = range;
    });
    Range whole;
    for (const Range& range : ranges) {
        whole.least = std::min(whole.least, range.least);
        whole.most = std::max(whole.most, range.most);
    }
    const unsigned width = count == 0 ? 0 : static_cast<unsigned>(std::bit_width(whole.most - whole.least));
    const unsigned shift = width > kBucketBits ? width - kBucketBits : 0;
    const auto bucketOf = [&](std::uint64_t key) { return (key - whole.least) >> shift; };

    // A stable scatter into buckets of neighbouring keys; each bucket is then small enough to sort in cache.
    std::vector<std::uint32_t> places(chunks * kBuckets, 0);
    parallelChunks(count, kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        std::uint32_t* counts = places.data() + chunk * kBuckets;
        eachKey(keysOf, begin, end, [&](std::size_t, std::uint64_t key) { ++counts[bucketOf(key)]; });
    });
    std::vector<std::uint32_t> starts(kBuckets + 1, 0);
    std::uint32_t place = 0;
    for (std::size_t bucket = 0; bucket < kBuckets; ++bucket) {
        starts[bucket] = place;
        for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
            const std::uint32_t many = places[chunk * kBuckets + bucket];
            places[chunk * kBuckets + bucket] = place;
            place += many;
        }
    }
    starts[kBuckets] = place;

    std::vector<KeyedIndex> sorted(count);
    parallelChunks(count, kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        std::uint32_t* next = places.data() + chunk * kBuckets;
        eachKey(keysOf, begin, end, [&](std::size_t item, std::uint64_t key) {
            sorted[next[bucketOf(key)]++] = {key, static_cast<std::uint32_t>(item)};
        });
    });
    if (shift == 0) return sorted;
    parallelFor(kBuckets, 1, [&](std::size_t bucket, std::size_t) {
        std::sort(sorted.begin() + starts[bucket], sorted.begin() + starts[bucket + 1],
                  [](const KeyedIndex& a, const KeyedIndex& b) {
                      return a.key != b.key ? a.key < b.key : a.index < b.index;
                  });
    });
    return sorted;
}

}  // namespace vestige
