#include "ui/view/PointBlocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/base/Parallel.h"
#include "core/geometry/Octree.h"
#include "tests/ui/view/Samples.h"

using namespace vestige;
using namespace vestige::test;

TEST(PointBlocks, HoldEveryPointOnce) {
    const auto square = flatSquare(400);
    const PointBlocks made = makePointBlocks(square->vertices, {}, kFar);
    std::vector<std::uint32_t> sorted = made.order;
    std::sort(sorted.begin(), sorted.end());
    ASSERT_EQ(sorted.size(), 160000U);
    for (std::uint32_t i = 0; i < sorted.size(); ++i) ASSERT_EQ(sorted[i], i);
    ASSERT_EQ(made.blocks.size(), 3U);
    EXPECT_EQ(made.blocks.front().begin, 0U);
    EXPECT_EQ(made.blocks.back().end, 160000U);
}

TEST(PointBlocks, PositionsKeepTheirDigitsFarFromTheOrigin) {
    const auto square = flatSquare(50);
    const PointBlocks made = makePointBlocks(square->vertices, {}, kFar);
    for (std::size_t i = 0; i < made.order.size(); ++i) {
        const Eigen::Vector3d exact = square->vertices.point(made.order[i]) - kFar;
        ASSERT_LT((made.positions[i].cast<double>() - exact).norm(), 1e-6);
    }
}

TEST(PointBlocks, TheFirstPointsOfABlockCoverIt) {
    const auto square = flatSquare(256);
    const PointBlocks made = makePointBlocks(square->vertices, {}, kFar);
    ASSERT_EQ(made.blocks.size(), 1U);
    // A hundredth of the points falls into every one of 8 x 8 cells.
    std::set<std::pair<int, int>> cells;
    for (std::size_t i = 0; i < made.order.size() / 100; ++i)
        cells.insert({static_cast<int>(made.positions[i].x() / 10.001 * 8),
                      static_cast<int>(made.positions[i].y() / 10.001 * 8)});
    EXPECT_EQ(cells.size(), 64U);
}

TEST(PointBlocks, DoNotDependOnThreads) {
    const auto square = flatSquare(300);
    setThreadCount(1);
    const PointBlocks one = makePointBlocks(square->vertices, {}, kFar);
    setThreadCount(7);
    const PointBlocks seven = makePointBlocks(square->vertices, {}, kFar);
    setThreadCount(0);
    EXPECT_EQ(one.order, seven.order);
    EXPECT_EQ(one.positions, seven.positions);
}

TEST(PointBlocks, KnowTheSpacingOfTheirPoints) {
    const auto square = flatSquare(101);  // 0.1 m
    const PointBlocks made = makePointBlocks(square->vertices, {}, kFar);
    EXPECT_NEAR(made.spacing_m, 0.1, 0.03);
    Similarity millimetres;
    millimetres.scale = 0.001;
    EXPECT_NEAR(makePointBlocks(square->vertices, millimetres, kFar).spacing_m, 0.0001, 0.00003);
}

TEST(PointBlocks, TakeTheOrderOfAnOctree) {
    const auto square = flatSquare(300);
    const Octree octree(std::shared_ptr<const PointCloud>(square, &square->vertices));
    const PointBlocks made = makePointBlocks(square->vertices, {}, kFar, octree.order());
    std::vector<std::uint32_t> first(made.order.begin(), made.order.begin() + 65536);
    std::vector<std::uint32_t> expected(octree.order().begin(), octree.order().begin() + 65536);
    std::sort(first.begin(), first.end());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(first, expected);
}
