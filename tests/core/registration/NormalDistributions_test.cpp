#include "core/registration/ndt/NormalDistributions.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/Parallel.h"
#include "core/base/Random.h"
#include "core/registration/ndt/MomentPyramid.h"
#include "core/registration/ndt/VoxelSchedule.h"

namespace vestige {
namespace {

std::vector<Eigen::Vector3f> plane(double noise, int count, double width = 0.9) {
    Random random(3);
    std::vector<Eigen::Vector3f> points;
    for (int i = 0; i < count; ++i)
        points.push_back(Eigen::Vector3d(0.05 + width * random.uniform(), 0.05 + 0.9 * random.uniform(),
                                         0.5 + random.normal(0, noise))
                             .cast<float>());
    return points;
}

NormalDistributions distributions(const std::vector<Eigen::Vector3f>& points, double size,
                                  DistributionOptions options = {}) {
    const VoxelGrid grid(size);
    return {gatherPoints(points, grid), grid, options};
}

TEST(CellMoments, AreMeanAndScatterOfThePoints) {
    const auto points = plane(0.1, 50);
    const auto cells = gatherPoints(points, VoxelGrid(1));
    ASSERT_EQ(cells.size(), 1U);
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const auto& point : points) mean += point.cast<double>() / 50;
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const auto& point : points) {
        const Eigen::Vector3d d = point.cast<double>() - mean;
        scatter += d * d.transpose();
    }
    EXPECT_EQ(cells[0].count, 50U);
    EXPECT_NEAR((cells[0].meanVector() - mean).norm(), 0, 1e-6);
    EXPECT_NEAR((cells[0].scatterMatrix() - scatter).norm(), 0, 1e-5 * scatter.norm());
}

TEST(CellMoments, MergeUpwardsWithoutLoss) {
    const auto points = plane(0.1, 5000);
    const auto small = gatherPoints(points, VoxelGrid(0.125));
    EXPECT_GT(small.size(), 50U);
    const auto merged = gatherCells(small, VoxelGrid(1));
    const auto direct = gatherPoints(points, VoxelGrid(1));
    ASSERT_EQ(merged.size(), direct.size());
    for (std::size_t i = 0; i < direct.size(); ++i) {
        const auto same = std::find_if(merged.begin(), merged.end(),
                                       [&](const CellMoments& cell) { return cell.key == direct[i].key; });
        ASSERT_NE(same, merged.end());
        EXPECT_EQ(same->count, direct[i].count);
        EXPECT_NEAR((same->scatterMatrix() - direct[i].scatterMatrix()).norm(), 0,
                    1e-5 * direct[i].scatterMatrix().norm());
    }
}

TEST(CellMoments, AreTheSameBitsForAnyThreadCount) {
    Random random(9);
    std::vector<Eigen::Vector3f> points;
    for (int i = 0; i < 200000; ++i)
        points.push_back(
            Eigen::Vector3d(random.uniform(-40, 40), random.uniform(-40, 40), random.normal()).cast<float>());
    setThreadCount(1);
    const auto one = MomentPyramid(points, 0.4, 4).at(VoxelGrid(1.3));
    for (const int threads : {2, 7}) {
        setThreadCount(threads);
        const auto many = MomentPyramid(points, 0.4, 4).at(VoxelGrid(1.3));
        ASSERT_EQ(one.size(), many.size());
        for (std::size_t i = 0; i < one.size(); ++i) {
            ASSERT_EQ(one[i].key, many[i].key);
            ASSERT_EQ(one[i].mean, many[i].mean);
            ASSERT_EQ(one[i].scatter, many[i].scatter);
        }
    }
    setThreadCount(0);
}

TEST(NormalDistributions, LeavesOutCellsWithTooFewPoints) {
    EXPECT_EQ(distributions(plane(0.1, 5), 1).size(), 0U);
    EXPECT_EQ(distributions(plane(0.1, 6), 1).size(), 1U);
}

TEST(NormalDistributions, FlatCellsHoldAcrossTheirPlaneOnly) {
    const auto points = plane(0.005, 500);
    const NormalDistributions cells = distributions(points, 1);
    const NormalCell* cell = cells.find(0.5, 0.5, 0.5);
    ASSERT_NE(cell, nullptr);
    EXPECT_LT(cell->information[0], 0.001 * cell->information[5]);
    DistributionOptions classic;
    classic.flatCellsInPlane = true;
    const NormalDistributions published = distributions(points, 1, classic);
    EXPECT_NEAR(published.find(0.5, 0.5, 0.5)->information[0], 1 / (0.81 / 12), 3);
}

TEST(NormalDistributions, ANearlySingularCellKeepsAnInverse) {
    const NormalDistributions cells = distributions(plane(0, 100), 1);
    const NormalCell* cell = cells.find(0.5, 0.5, 0.5);
    ASSERT_NE(cell, nullptr);
    EXPECT_TRUE(std::isfinite(cell->information[5]));
    EXPECT_LT(cell->depth, 0);
    EXPECT_GT(cell->steepness, 0);
}

TEST(NormalDistributions, RangeNoiseDoesNotHideAPlane) {
    const auto points = plane(0.05, 2000);
    EXPECT_EQ(distributions(points, 1).flatness().flat, 0U);
    DistributionOptions known;
    known.rangeNoise_m = 0.05;
    EXPECT_EQ(distributions(points, 1, known).flatness().flat, 1U);
}

TEST(NormalDistributions, TheThicknessOfAPlaneIsItsNoise) {
    for (const double noise : {0.0, 0.01, 0.03}) {
        const auto points = plane(noise, 20000);
        EXPECT_NEAR(surfaceThickness(gatherPoints(points, VoxelGrid(1))), noise, 0.05 * noise + 1e-6);
    }
    EXPECT_EQ(surfaceThickness(gatherPoints(plane(0.03, 5), VoxelGrid(1))), 0);
}

TEST(NormalDistributions, ALineIsNoPlaneAndHasNoVote) {
    EXPECT_EQ(distributions(plane(0.001, 100, 0.1), 1).flatness().cells, 0U);
    EXPECT_EQ(distributions(plane(0.001, 100), 1).flatness().cells, 1U);
    EXPECT_EQ(distributions(plane(0.001, 9), 1).flatness().cells, 0U);
}

TEST(VoxelSchedule, ShrinksByAFifthAndEndsAtTheSmallest) {
    const auto sizes = voxelSchedule(1, 0.5, 0.8);
    ASSERT_EQ(sizes.size(), 5U);
    EXPECT_DOUBLE_EQ(sizes[1], 0.8);
    EXPECT_DOUBLE_EQ(sizes[3], 0.512);
    EXPECT_DOUBLE_EQ(sizes.back(), 0.5);
    EXPECT_EQ(voxelSchedule(1, 0.8, 0.8), (std::vector<double>{1, 0.8}));
    EXPECT_EQ(voxelSchedule(0.5, 0.5, 0.8), (std::vector<double>{0.5}));
}

TEST(VoxelSchedule, TheSmallestOfTheFlattestSizesThatHoldHalfOfThePoints) {
    // voxel, voting cells, flat, points in them; of 1000 points.
    const std::vector<FlatnessCount> counts{{1, 100, 50, 1000},
                                            {0.8, 100, 80, 900},
                                            {0.64, 100, 79, 700},
                                            {0.5, 100, 70, 500},
                                            {0.4, 100, 99, 499}};
    EXPECT_EQ(finestByFlatness(counts, 1000), 2U);
    EXPECT_EQ(finestByFlatness(counts, 1000, 0.5), 3U);
    EXPECT_EQ(finestByFlatness(counts, 1000, 0.1), 3U);
    EXPECT_TRUE(pastLeastShare(counts, 1000));
    EXPECT_EQ(finestByFlatness({{1, 10, 5, 100}}, 1000), 0U);
}

}  // namespace
}  // namespace vestige
