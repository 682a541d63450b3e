#include "core/geometry/SortedKeys.h"

#include <algorithm>
#include <array>
#include <bit>

#include "core/base/Parallel.h"

namespace vestige {
namespace {

constexpr std::size_t kGrain = 65536;
constexpr unsigned kFirstDigitBits = 12;
constexpr std::size_t kBuckets = std::size_t{1} << kFirstDigitBits;
constexpr unsigned kDigitBits = 8;
constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;
constexpr std::size_t kFewItems = 48;
constexpr std::size_t kBlock = 1024;

/// Calls use(index, key) for every item of [begin, end), in order.
template <class Key, class Use>
void eachKey(const KeysOf<Key>& keysOf, std::size_t begin, std::size_t end, const Use& use) {
    std::array<Key, kBlock> keys;
    for (std::size_t at = begin; at < end; at += kBlock) {
        const std::size_t many = std::min(kBlock, end - at);
        keysOf(at, std::span(keys).first(many));
        for (std::size_t i = 0; i < many; ++i) use(at + i, keys[i]);
    }
}

/// Sorts items that come in ascending order of index; `spare` is as long as `items`.
template <class Key>
void sortStable(std::span<KeyedIndex<Key>> items, std::span<KeyedIndex<Key>> spare) {
    if (items.size() <= kFewItems) {
        std::sort(items.begin(), items.end(), [](const auto& a, const auto& b) {
            return a.key != b.key ? a.key < b.key : a.index < b.index;
        });
        return;
    }
    Key differing = 0;
    for (const auto& item : items) differing |= item.key ^ items.front().key;
    if (differing == 0) return;
    const auto width = static_cast<unsigned>(std::bit_width(differing));
    const unsigned shift = width > kDigitBits ? width - kDigitBits : 0;
    const auto digit = [shift](Key key) { return static_cast<std::size_t>(key >> shift) % kDigits; };

    std::array<std::uint32_t, kDigits + 1> places{};
    for (const auto& item : items) ++places[digit(item.key) + 1];
    for (std::size_t i = 1; i <= kDigits; ++i) places[i] += places[i - 1];
    std::array<std::uint32_t, kDigits> next;
    std::copy_n(places.begin(), kDigits, next.begin());
    for (const auto& item : items) spare[next[digit(item.key)]++] = item;
    std::copy_n(spare.begin(), items.size(), items.begin());
    if (shift == 0) return;
    for (std::size_t i = 0; i < kDigits; ++i) {
        const std::size_t many = places[i + 1] - places[i];
        if (many > 1) sortStable(items.subspan(places[i], many), spare.subspan(places[i], many));
    }
}

}  // namespace

template <class Key>
LargeArray<KeyedIndex<Key>> sortedByKey(std::size_t count, unsigned keyBits, const KeysOf<Key>& keysOf) {
    const std::size_t chunks = (count + kGrain - 1) / kGrain;
    const unsigned shift = keyBits > kFirstDigitBits ? keyBits - kFirstDigitBits : 0;
    const auto bucketOf = [shift](Key key) { return static_cast<std::size_t>(key >> shift); };

    std::vector<std::uint32_t> places(chunks * kBuckets, 0);
    parallelChunks(count, kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        std::uint32_t* counts = places.data() + chunk * kBuckets;
        eachKey(keysOf, begin, end, [&](std::size_t, Key key) { ++counts[bucketOf(key)]; });
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

    auto sorted = LargeArray<KeyedIndex<Key>>::toFill(count);
    parallelChunks(count, kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        std::uint32_t* next = places.data() + chunk * kBuckets;
        eachKey(keysOf, begin, end, [&](std::size_t item, Key key) {
            sorted[next[bucketOf(key)]++] = {key, static_cast<std::uint32_t>(item)};
        });
    });
    if (shift == 0) return sorted;
    parallelFor(kBuckets, 16, [&](std::size_t begin, std::size_t end) {
        LargeArray<KeyedIndex<Key>> spare;
        for (std::size_t bucket = begin; bucket < end; ++bucket) {
            const std::size_t many = starts[bucket + 1] - starts[bucket];
            if (spare.size() < many) spare.resizeToFill(many);
            sortStable(std::span(sorted).subspan(starts[bucket], many), std::span(spare).first(many));
        }
    });
    return sorted;
}

template LargeArray<KeyedIndex<std::uint32_t>> sortedByKey(std::size_t, unsigned,
                                                           const KeysOf<std::uint32_t>&);
template LargeArray<KeyedIndex<std::uint64_t>> sortedByKey(std::size_t, unsigned,
                                                           const KeysOf<std::uint64_t>&);

}  // namespace vestige
