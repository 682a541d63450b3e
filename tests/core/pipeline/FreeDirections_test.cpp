#include "core/pipeline/FreeDirections.h"

#include <gtest/gtest.h>

namespace vestige {
namespace {

RegistrationQuality qualityWith(const Vector6d& direction, bool free) {
    RegistrationQuality quality;
    quality.radius_m = 1.5;
    quality.uncertainty.pivot_m = {10, 20, 3};
    ObservedDirection observed;
    observed.direction = direction.normalized();
    observed.free = free;
    observed.words = "slides";
    quality.directions = {observed};
    return quality;
}

TEST(FreeDirections, ASlideIsAStraightArrowThroughTheMiddle) {
    Vector6d slide = Vector6d::Zero();
    slide.head<3>() << 3, 4, 0;
    slide[5] = 0.2;
    const auto arrows = freeDirectionArrows(qualityWith(slide, true));
    ASSERT_EQ(arrows.size(), 1u);
    EXPECT_EQ(arrows[0].label, "slides");
    ASSERT_EQ(arrows[0].path.size(), 2u);
    const Eigen::Vector3d run = arrows[0].path[1] - arrows[0].path[0];
    EXPECT_LT(run.normalized().cross(Eigen::Vector3d(0.6, 0.8, 0)).norm(), 1e-12);
    EXPECT_LT((0.5 * (arrows[0].path[0] + arrows[0].path[1]) - Eigen::Vector3d(10, 20, 3)).norm(), 1e-12);
    EXPECT_NEAR(run.norm(), 6, 1e-12);
}

TEST(FreeDirections, ATurnIsAnArcRoundItsAxis) {
    Vector6d turn = Vector6d::Zero();
    turn[0] = 0.1;
    turn[5] = 1;
    const auto arrows = freeDirectionArrows(qualityWith(turn, true));
    ASSERT_EQ(arrows.size(), 1u);
    ASSERT_GT(arrows[0].path.size(), 10u);
    for (const Eigen::Vector3d& point : arrows[0].path) {
        EXPECT_NEAR(point.z(), 3, 1e-12) << "about the vertical";
        EXPECT_NEAR((point - Eigen::Vector3d(10, 20, 3)).norm(), 1.5, 1e-12);
    }
    EXPECT_GT((arrows[0].path.front() - arrows[0].path.back()).norm(), 2);
}

TEST(FreeDirections, WhatTheDataHoldHasNoArrow) {
    EXPECT_TRUE(freeDirectionArrows(qualityWith(Vector6d::UnitX(), false)).empty());
}

}  // namespace
}  // namespace vestige
