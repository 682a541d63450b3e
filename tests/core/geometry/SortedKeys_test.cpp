#include "core/geometry/SortedKeys.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/Parallel.h"
#include "core/base/Random.h"

using namespace vestige;

namespace {

template <class Key>
void expectStableOrder(std::vector<Key> keys, unsigned keyBits) {
    std::vector<std::uint32_t> expected(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) expected[i] = static_cast<std::uint32_t>(i);
    std::stable_sort(expected.begin(), expected.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return keys[a] < keys[b]; });
    for (const int threads : {1, 2, 7}) {
        setThreadCount(threads);
        const auto sorted =
            sortedByKey<Key>(keys.size(), keyBits, [&](std::size_t begin, std::span<Key> into) {
                std::copy_n(keys.begin() + static_cast<std::ptrdiff_t>(begin), into.size(), into.begin());
            });
        ASSERT_EQ(sorted.size(), keys.size());
        for (std::size_t i = 0; i < sorted.size(); ++i) {
            ASSERT_EQ(sorted[i].index, expected[i]) << keyBits << ' ' << keys.size() << ' ' << threads;
            ASSERT_EQ(sorted[i].key, keys[expected[i]]);
        }
    }
    setThreadCount(0);
}

template <class Key>
std::vector<Key> randomKeys(std::size_t count, unsigned keyBits, std::uint64_t range) {
    Random random(3);
    std::vector<Key> keys(count);
    for (auto& key : keys) key = static_cast<Key>(random.below(range));
    // One far key makes the buckets uneven.
    if (count > 1) keys[count / 2] = static_cast<Key>(~std::uint64_t{0} >> (64 - keyBits));
    return keys;
}

}  // namespace

TEST(SortedKeys, SortsLikeAStableSortForAnyKeysAndThreads) {
    for (const std::size_t count : {0U, 1U, 1000U, 200000U}) {
        for (const unsigned bits : {1U, 12U, 13U, 22U, 32U})
            expectStableOrder(randomKeys<std::uint32_t>(count, bits, std::uint64_t{1} << bits), bits);
        expectStableOrder(randomKeys<std::uint32_t>(count, 32, 5000), 32);
        for (const std::uint64_t range : {std::uint64_t{1}, std::uint64_t{5000}, std::uint64_t{1} << 63})
            expectStableOrder(randomKeys<std::uint64_t>(count, 63, range), 63);
    }
}
