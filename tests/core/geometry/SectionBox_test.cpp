#include "core/geometry/SectionBox.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace vestige {
namespace {

TEST(SectionBox, ItsSidesHoldWhatItContains) {
    const SectionBox box{{500000, 4000000, 30}, {4, 2, 1}, 0.7};
    const auto planes = box.planes();
    ASSERT_EQ(planes.size(), 6u);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> spread(-6, 6);
    int inside = 0;
    for (int i = 0; i < 2000; ++i) {
        const Eigen::Vector3d point =
            box.centre + Eigen::Vector3d(spread(random), spread(random), spread(random));
        const bool held = std::all_of(planes.begin(), planes.end(), [&](const ClipPlane& plane) {
            return plane.normal.dot(point) + plane.distance >= 0;
        });
        EXPECT_EQ(held, box.contains(point));
        inside += held;
    }
    EXPECT_GT(inside, 20);
}

TEST(SectionBox, TurnsFromXTowardsY) {
    const SectionBox box{{0, 0, 0}, {3, 1, 1}, 1.5707963267948966};
    EXPECT_TRUE(box.contains({0, 2.9, 0}));
    EXPECT_FALSE(box.contains({2.9, 0, 0}));
}

}  // namespace
}  // namespace vestige
