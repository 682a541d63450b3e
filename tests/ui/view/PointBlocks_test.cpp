#include "ui/view/PointBlocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "core/base/Parallel.h"
#include "core/geometry/PointCloudBuilder.h"
#include "tests/ui/view/Samples.h"

using namespace vestige;
using namespace vestige::test;

namespace {

std::shared_ptr<const Octree> octreeOf(const std::shared_ptr<const TriangleMesh>& mesh) {
    return std::make_shared<Octree>(std::shared_ptr<const PointCloud>(mesh, &mesh->vertices));
}

std::vector<std::uint32_t> drawingOrder(const PointBlocks& blocks) {
    std::vector<std::uint32_t> order;
    for (std::size_t block = 0; block < blocks.blocks().size(); ++block)
        for (std::uint32_t rank = 0; rank < blocks.blocks()[block].size(); ++rank)
            order.push_back(blocks.point(block, rank));
    return order;
}

}  // namespace

TEST(PointBlocks, HoldEveryPointOnce) {
    for (const int side : {1, 2, 37, 256, 400}) {
        const PointBlocks made(octreeOf(flatSquare(side)), {});
        std::vector<std::uint32_t> sorted = drawingOrder(made);
        std::sort(sorted.begin(), sorted.end());
        std::vector<std::uint32_t> all(static_cast<std::size_t>(side) * side);
        std::iota(all.begin(), all.end(), 0U);
        ASSERT_EQ(sorted, all) << side;
        ASSERT_EQ(made.blocks().size(), (all.size() + 65535) / 65536);
        EXPECT_EQ(made.blocks().front().begin, 0U);
        EXPECT_EQ(made.blocks().back().end, all.size());
    }
}

TEST(PointBlocks, HoldTheirPointsInTheirBoxes) {
    const auto square = flatSquare(400);
    Similarity worldFromLayer;
    worldFromLayer.scale = 0.5;
    worldFromLayer.pose = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ());
    const PointBlocks made(octreeOf(square), worldFromLayer);
    for (std::size_t block = 0; block < made.blocks().size(); ++block) {
        BoundingBox box = made.blocks()[block].box;
        EXPECT_LT(box.diagonal(), 12) << "half of a square of 10 m, turned";
        for (std::uint32_t rank = 0; rank < made.blocks()[block].size(); ++rank) {
            const Eigen::Vector3d point = worldFromLayer * square->vertices.point(made.point(block, rank));
            ASSERT_TRUE((point.array() >= box.min.array() - 1e-6).all());
            ASSERT_TRUE((point.array() <= box.max.array() + 1e-6).all());
        }
    }
}

TEST(PointBlocks, TheFirstPointsOfABlockCoverIt) {
    const auto square = flatSquare(256);
    const PointBlocks made(octreeOf(square), {});
    ASSERT_EQ(made.blocks().size(), 1U);
    // A hundredth of the points falls into every one of 8 x 8 cells.
    std::set<std::pair<int, int>> cells;
    for (std::uint32_t rank = 0; rank < made.blocks()[0].size() / 100; ++rank) {
        const Eigen::Vector3d place = square->vertices.point(made.point(0, rank)) - kFar;
        cells.insert({static_cast<int>(place.x() / 10.001 * 8), static_cast<int>(place.y() / 10.001 * 8)});
    }
    EXPECT_EQ(cells.size(), 64U);
}

TEST(PointBlocks, DoNotDependOnThreads) {
    const auto square = flatSquare(300);
    setThreadCount(1);
    const PointBlocks one(octreeOf(square), {});
    setThreadCount(7);
    const PointBlocks seven(octreeOf(square), {});
    setThreadCount(0);
    EXPECT_EQ(drawingOrder(one), drawingOrder(seven));
    for (std::size_t i = 0; i < one.blocks().size(); ++i) {
        EXPECT_EQ(one.blocks()[i].box.min, seven.blocks()[i].box.min);
        EXPECT_EQ(one.blocks()[i].spacing_m, seven.blocks()[i].spacing_m);
    }
}

TEST(PointBlocks, KnowTheSpacingOfTheirPoints) {
    const auto square = flatSquare(101);  // 0.1 m
    const PointBlocks made(octreeOf(square), {});
    EXPECT_NEAR(made.spacing_m(), 0.1, 0.03);
    EXPECT_NEAR(made.blocks()[0].spacing_m, 0.1, 0.05);
    Similarity millimetres;
    millimetres.scale = 0.001;
    const PointBlocks small(octreeOf(square), millimetres);
    EXPECT_NEAR(small.spacing_m(), 0.0001, 0.00003);
    EXPECT_NEAR(small.blocks()[0].spacing_m, 0.0001, 0.00005);
}

TEST(PointBlocks, DoNotTakePointsThatCoincideForNear) {
    const auto square = flatSquare(101);  // 0.1 m
    for (const int times : {2, 3, 6}) {
        const PointBlocks made(octreeOf(repeated(*square, times)), {});
        EXPECT_NEAR(made.spacing_m(), 0.1, 0.03) << times;
        EXPECT_NEAR(made.blocks()[0].spacing_m, 0.1, 0.05) << times;
    }
    // Nineteen in twenty points in one place, as a scanner writes what it did not see.
    PointCloudBuilder builder;
    for (int i = 0; i < 19 * 3000; ++i) builder.add(kFar + Eigen::Vector3d(5, 5, 0));
    for (int i = 0; i < 3000; ++i) builder.add(kFar + Eigen::Vector3d(0.1 * (i % 60), 0.1 * (i / 60), 0));
    auto heaped = std::make_shared<TriangleMesh>();
    heaped->vertices = std::move(builder).build();
    const PointBlocks made(octreeOf(heaped), {});
    ASSERT_EQ(made.blocks().size(), 1U);
    EXPECT_GT(made.blocks()[0].spacing_m, 0.05);
    EXPECT_GT(made.spacing_m(), 0.05);
    const PointBlocks one(octreeOf(repeated(*onePoint(kFar), 1000)), {});
    EXPECT_EQ(one.spacing_m(), 0);
    EXPECT_EQ(one.blocks()[0].spacing_m, 0);
}

TEST(PointBlocks, AskForTheirPointsByThePixelsTheyCover) {
    PointBlock block;
    block.end = 65536;
    block.spacing_m = 0.05;
    EXPECT_EQ(pointsWorthDrawing(block, 0), 65536U) << "the camera is in it";
    EXPECT_EQ(pointsWorthDrawing(block, 0.05), 65536U) << "a point a pixel is not yet two a pixel's side";
    EXPECT_NEAR(pointsWorthDrawing(block, 1), 0.01 * 65536, 1) << "0.5 m apart are 100 points a point";
    EXPECT_EQ(pointsWorthDrawing(block, 1000), 64U) << "what is far is still seen";
    block.end = 10;
    EXPECT_EQ(pointsWorthDrawing(block, 1000), 10U);
    block.spacing_m = 0;
    EXPECT_EQ(pointsWorthDrawing(block, 0), 10U) << "points that all coincide, seen from within";
}
