#include "ui/jobs/TimeLeft.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vestige {
namespace {

TEST(TimeLeft, SaysNothingWhileNobodyCanTell) {
    TimeLeft job(100);
    job.update(100.5, 0.5);
    EXPECT_FALSE(job.left_s(100.5)) << "the first second";
    job.update(102, 0.001);
    EXPECT_FALSE(job.left_s(102)) << "next to nothing is done";
}

TEST(TimeLeft, OfAnEvenJobItIsRight) {
    TimeLeft job(5);
    for (double passed = 0.5; passed < 20; passed += 0.5) {
        job.update(5 + passed, passed / 20);
        if (passed < 1) continue;
        ASSERT_TRUE(job.left_s(5 + passed));
        EXPECT_NEAR(*job.left_s(5 + passed), 20 - passed, 1e-9);
    }
}

TEST(TimeLeft, OfAnUnevenJobItDoesNotJump) {
    // A first stage that says it is half of the job and is a tenth of it.
    const auto share = [](double passed) {
        return passed < 6 ? 0.5 * passed / 6 : 0.5 + 0.5 * (passed - 6) / 54;
    };
    TimeLeft job(0);
    double before = 0;
    for (double now = 0.5; now < 60; now += 0.5) {
        job.update(now, share(now));
        const double left = job.left_s(now).value_or(0);
        if (now > 2) {
            EXPECT_LT(std::abs(left - before), 2.5) << "at " << now;
        }
        if (now > 40) {
            EXPECT_NEAR(left, 60 - now, 0.25 * (60 - now) + 5) << "at " << now;
        }
        before = left;
    }
}

TEST(TimeLeft, AJobThatStandsStillIsNotAboutToEnd) {
    TimeLeft job(0);
    for (double now = 0.5; now <= 10; now += 0.5) job.update(now, now / 20);
    for (double now = 10.5; now <= 60; now += 0.5) job.update(now, 0.5);
    EXPECT_GT(*job.left_s(60), 20);
}

TEST(TimeLeft, IsSaidInWords) {
    EXPECT_EQ(timeLeftText(0), "1 s left");
    EXPECT_EQ(timeLeftText(11.6), "12 s left");
    EXPECT_EQ(timeLeftText(41), "about 40 s left");
    EXPECT_EQ(timeLeftText(57.6), "1 min left");
    EXPECT_EQ(timeLeftText(170), "3 min left");
}

}  // namespace
}  // namespace vestige
