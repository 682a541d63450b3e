#include "core/evaluation/RelativePoseError.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/evaluation/EvaluationClouds.h"

namespace vestige {
namespace {

using test::pose;
using test::walk;

TEST(RelativePoseError, IsZeroForTheTruthInAnyFrame) {
    std::vector<Pose> moved;
    for (const Pose& one : walk()) moved.push_back(pose(100, 50, 2) * one);
    for (const std::size_t distance : {1, 2, 3}) {
        const auto none = relativePoseError(moved, walk(), distance);
        ASSERT_TRUE(none);
        EXPECT_LT(none->largest.translation_m, 1e-12);
        EXPECT_LT(none->largest.rotation_rad, 1e-7);
        EXPECT_EQ(none->pairs, 4 - distance);
    }
}

TEST(RelativePoseError, IsTheRootMeanSquareOverTheSteps) {
    const std::vector<Pose> truth = walk();
    // The second step ends 0.3 m aside; the third starts from there and is right.
    std::vector<Pose> wrong = truth;
    wrong[2] = truth[1] * pose(0.3, 0, 0) * truth[1].inverse() * truth[2];
    wrong[3] = wrong[2] * truth[2].inverse() * truth[3];
    const auto some = relativePoseError(wrong, truth);
    ASSERT_TRUE(some);
    EXPECT_NEAR(some->translation_m, 0.3 / std::sqrt(3.0), 1e-9);
    EXPECT_LT(some->rotation_rad, 1e-7);
    EXPECT_NEAR(some->largest.translation_m, 0.3, 1e-9);
    EXPECT_LT(some->median.translation_m, 1e-9);
    ASSERT_EQ(some->each.size(), 3U);
    EXPECT_NEAR(some->each[1].translation_m, 0.3, 1e-9);
    // Two apart, both pairs go over the wrong step.
    const auto two = relativePoseError(wrong, truth, 2);
    ASSERT_TRUE(two);
    EXPECT_NEAR(two->translation_m, 0.3, 1e-9);
    EXPECT_NEAR(two->median.translation_m, 0.3, 1e-9);
}

TEST(RelativePoseError, OfAChainThatTurnsTooFarIsWhatGeometrySays) {
    // A straight walk of 1 m steps; the estimate turns by `a` more at every step: one step is off by the
    // angle alone, two steps by the chord 2 sin(a / 2) and 2 a.
    constexpr double a = 0.02;
    std::vector<Pose> truth{Pose::Identity()}, estimate{Pose::Identity()};
    for (int i = 0; i < 6; ++i) {
        truth.push_back(truth.back() * pose(1, 0, 0));
        estimate.push_back(estimate.back() * pose(1, 0, a));
    }
    const auto one = relativePoseError(estimate, truth);
    ASSERT_TRUE(one);
    EXPECT_LT(one->translation_m, 1e-12);
    EXPECT_NEAR(one->rotation_rad, a, 1e-12);
    const auto two = relativePoseError(estimate, truth, 2);
    ASSERT_TRUE(two);
    EXPECT_NEAR(two->translation_m, 2 * std::sin(a / 2), 1e-12);
    EXPECT_NEAR(two->rotation_rad, 2 * a, 1e-12);
}

TEST(RelativePoseError, NeedsPairs) {
    const std::vector<Pose> truth = walk();
    EXPECT_FALSE(relativePoseError(truth, std::span(truth).first(3)));
    EXPECT_FALSE(relativePoseError(truth, truth, 4));
    EXPECT_FALSE(relativePoseError(truth, truth, 0));
}

}  // namespace
}  // namespace vestige
