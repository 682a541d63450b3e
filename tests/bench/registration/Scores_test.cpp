#include "tests/bench/registration/Scores.h"

#include <gtest/gtest.h>

#include <array>

#include "core/base/Units.h"

namespace vestige::bench {
namespace {

constexpr PoseError mm(double millimetres, double degrees) {
    return {millimetres / 1000, radians(degrees)};
}

TEST(Scores, ErrorOfAPose) {
    Pose truth = Pose::Identity();
    truth.translation() << 1, 2, 3;
    Pose found = truth;
    found.translation() += Eigen::Vector3d(0.03, 0, 0.04);
    found.rotate(Eigen::AngleAxisd(radians(2), Eigen::Vector3d::UnitY()));
    const PoseError error = poseError(found, truth);
    EXPECT_NEAR(error.translation_m, 0.05, 1e-12);
    EXPECT_NEAR(degrees(error.rotation_rad), 2, 1e-9);
    EXPECT_NEAR(errorAt10m(error), 0.05 + 10 * radians(2), 1e-12);
}

TEST(Scores, ErrorsBelowTheReferencesOwnAreEqual) {
    EXPECT_TRUE(notLarger(mm(2, 0.01), mm(2, 0.01), {}));
    EXPECT_FALSE(notLarger(mm(3, 0.01), mm(2, 0.01), {}));
    EXPECT_FALSE(notLarger(mm(2, 0.02), mm(2, 0.01), {}));
    EXPECT_TRUE(notLarger(mm(19, 0.2), mm(2, 0.01), mm(20, 0.3)));
    EXPECT_FALSE(notLarger(mm(21, 0.2), mm(2, 0.01), mm(20, 0.3)));
}

TEST(Scores, APeerCountsAtItsFastestSettingThatIsAsAccurateAsOurs) {
    const std::array runs{SettingRun{1.0, 0.010, mm(9, 0.1)}, SettingRun{0.4, 0.050, mm(1, 0.01)},
                          SettingRun{0.2, 0.040, mm(2, 0.01)}, SettingRun{0.1, 0.020, mm(60, 0.5)}};
    EXPECT_EQ(countingSetting(runs, mm(2, 0.02), {}), 2U);
    EXPECT_EQ(countingSetting(runs, mm(10, 0.2), {}), 0U);
    EXPECT_EQ(countingSetting(runs, mm(0.1, 0.001), {}), 1U) << "else the most accurate";
    EXPECT_EQ(countingSetting(runs, mm(0.1, 0.001), mm(20, 0.3)), 0U);
    EXPECT_FALSE(countingSetting({}, mm(2, 0.02), {}));
}

TEST(Scores, MiddleAndRatios) {
    EXPECT_EQ(median({5}), 5);
    EXPECT_EQ(median({9, 1, 5}), 5);
    EXPECT_EQ(median({9, 1, 5, 3}), 4);
    EXPECT_EQ(minimum({9, 1, 5, 3}), 1);
    // The second round was twice as slow for both, the third was refused.
    const RoundTimes peer{{10, 12, 11}, {22, 22}, {}, {30}};
    const RoundTimes ours{{1}, {2}, {1}, {1, 2, 3}};
    EXPECT_EQ(ratiosByRound(peer, ours), (std::vector<double>{11, 11, 15}));
}

TEST(Scores, OverATenthOfAMetreIsAMiss) {
    EXPECT_FALSE(missed(mm(100, 5)));
    EXPECT_TRUE(missed(mm(100.1, 0)));
}

}  // namespace
}  // namespace vestige::bench
