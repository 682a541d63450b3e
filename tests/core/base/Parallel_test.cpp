#include "core/base/Parallel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace vestige;

namespace {

double sumWith(int threads) {
    setThreadCount(threads);
    const double sum = parallelSum(100001, 1000, 0.0, [](std::size_t begin, std::size_t end) {
        double part = 0;
        for (std::size_t i = begin; i < end; ++i) part += std::sin(static_cast<double>(i)) * 1e-3;
        return part;
    });
    setThreadCount(0);
    return sum;
}

}  // namespace

TEST(Parallel, SumIsTheSameBitForBitForAnyThreadCount) {
    const double one = sumWith(1);
    EXPECT_EQ(one, sumWith(2));
    EXPECT_EQ(one, sumWith(7));
    EXPECT_EQ(one, sumWith(0));
}

TEST(Parallel, EveryIndexOnce) {
    std::vector<int> seen(12345, 0);
    parallelFor(seen.size(), 100, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ++seen[i];
    });
    EXPECT_EQ(seen, std::vector<int>(12345, 1));
}

TEST(Parallel, AnExceptionLeavesTheLoop) {
    EXPECT_THROW(parallelFor(1000, 10,
                             [](std::size_t begin, std::size_t) {
                                 if (begin == 500) throw std::runtime_error("stop");
                             }),
                 std::runtime_error);
}
