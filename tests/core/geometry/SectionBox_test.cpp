#include "core/geometry/SectionBox.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
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
        EXPECT_EQ(held, box.region().keeps(point));
        SectionBox other = box;
        other.inverted = true;
        EXPECT_NE(held, other.region().keeps(point));
        EXPECT_NE(held, other.keeps(point));
        inside += held;
    }
    EXPECT_GT(inside, 20);
}

/// What `kept` says of a box in a turned frame holds for every place in it.
TEST(SectionBox, SaysOfBoxesWhatHoldsForAllOfThem) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> spread(-6, 6);
    std::uniform_real_distribution<double> share(-1, 1);
    const auto place = [&](auto& from) { return Eigen::Vector3d(from(random), from(random), from(random)); };
    SectionBox box{{500000, 4000000, 30}, {4, 2, 1}, 0.7};
    const Eigen::Matrix3d turn =
        0.001 * Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
    std::array<int, 3> answers{};
    for (int i = 0; i < 3000; ++i) {
        box.inverted = i % 2;
        const Eigen::Vector3d middle = 1000 * place(spread);
        const Eigen::Vector3d half = (i % 3 == 0 ? 3000 : 300) * place(share).cwiseAbs();
        const ClipRegion region = box.region();
        const Kept answer = kept(region, turn, box.centre, middle, half);
        ++answers[static_cast<std::size_t>(answer)];
        if (answer == Kept::part) continue;
        for (int k = 0; k < 10; ++k) {
            const Eigen::Vector3d at = turn * (middle + half.cwiseProduct(place(share))) + box.centre;
            ASSERT_EQ(region.keeps(at), answer == Kept::all) << i;
        }
    }
    for (const int count : answers) EXPECT_GT(count, 100);
}

TEST(SectionBox, TurnsFromXTowardsY) {
    const SectionBox box{{0, 0, 0}, {3, 1, 1}, 1.5707963267948966};
    EXPECT_TRUE(box.contains({0, 2.9, 0}));
    EXPECT_FALSE(box.contains({2.9, 0, 0}));
}

}  // namespace
}  // namespace vestige
