#include "core/base/Parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "core/base/CancelScope.h"
#include "core/base/Result.h"

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

TEST(Parallel, LoopsEndWhenTheirJobIsCancelled) {
    const JobControl control;
    std::atomic<int> chunks = 0;
    {
        const CancelScope scope(control);
        const Status done = guarded("the loop", [&]() -> Status {
            parallelFor(100'000, 1, [&](std::size_t, std::size_t) {
                if (++chunks == 10) control.cancel();
                std::this_thread::sleep_for(std::chrono::microseconds(20));
            });
            return {};
        });
        ASSERT_FALSE(done);
        EXPECT_EQ(done.error().code, ErrorCode::cancelled);
        EXPECT_LT(chunks, 50'000);
        EXPECT_THROW(throwIfCancelled(), ErrorException);
    }
    std::size_t all = 0;
    parallelFor(100, 100, [&](std::size_t begin, std::size_t end) { all += end - begin; });
    EXPECT_EQ(all, 100U) << "outside of the scope nothing is cancelled";
    throwIfCancelled();
}
