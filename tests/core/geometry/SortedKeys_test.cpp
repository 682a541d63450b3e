#include "core/geometry/SortedKeys.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/Parallel.h"
#include "core/base/Random.h"

using namespace vestige;

namespace {

std::vector<KeyedIndex> sortedOf(const std::vector<std::uint64_t>& keys) {
    return sortedByKey(keys.size(), [&](std::size_t begin, std::span<std::uint64_t> into) {
        std::copy_n(keys.begin() + static_cast<std::ptrdiff_t>(begin), into.size(), into.begin());
    });
}

}  // namespace

TEST(SortedKeys, SortsLikeAStableSortForAnyKeysAndThreads) {
    Random random(3);
    for (const std::uint64_t range :
         {std::uint64_t{1}, std::uint64_t{7}, std::uint64_t{5000}, ~std::uint64_t{0}}) {
        for (const std::size_t count : {0U, 1U, 1000U, 200000U}) {
            std::vector<std::uint64_t> keys(count);
            for (auto& key : keys) key = random.below(range);
            // One far key makes the buckets uneven.
            if (count > 1) keys[count / 2] = ~std::uint64_t{0};
            std::vector<std::uint32_t> expected(count);
            for (std::size_t i = 0; i < count; ++i) expected[i] = static_cast<std::uint32_t>(i);
            std::stable_sort(expected.begin(), expected.end(),
                             [&](std::uint32_t a, std::uint32_t b) { return keys[a] < keys[b]; });
            for (const int threads : {1, 2, 7}) {
                setThreadCount(threads);
                const auto sorted = sortedOf(keys);
                ASSERT_EQ(sorted.size(), count);
                for (std::size_t i = 0; i < count; ++i) {
                    ASSERT_EQ(sorted[i].index, expected[i]) << range << ' ' << count << ' ' << threads;
                    ASSERT_EQ(sorted[i].key, keys[expected[i]]);
                }
            }
        }
    }
    setThreadCount(0);
}
