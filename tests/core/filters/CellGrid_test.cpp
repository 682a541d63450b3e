#include "core/filters/CellGrid.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "core/filters/NearbyPoints.h"
#include "tests/core/filters/FilterClouds.h"

using namespace vestige;
using namespace vestige::test;

TEST(CellGrid, EveryPointLiesInItsCell) {
    const PointCloud cloud = cloudOf(roughScene(20000, {-3, 5, 0}));
    const CellGrid grid(cloud, 0.25, {});
    std::set<std::uint32_t> seen;
    for (std::size_t cell = 0; cell < grid.cellCount(); ++cell) {
        if (cell > 0) {
            ASSERT_LT(grid.key(cell - 1), grid.key(cell));
        }
        ASSERT_EQ(grid.firstCell(grid.key(cell)), cell);
        for (const std::uint32_t point : grid.points(cell)) {
            seen.insert(point);
            const Eigen::Vector3d within = cloud.point(point) - grid.corner(cell);
            ASSERT_GE(within.minCoeff(), 0);
            ASSERT_LT(within.maxCoeff(), 0.25);
        }
    }
    EXPECT_EQ(seen.size(), cloud.size());
}

TEST(CellGrid, CoversUpToItsMostCells) {
    const PointCloud cloud = cloudOf({{0.5, 0, 0}, {2097148.5, 0, 0}});
    EXPECT_TRUE(CellLayout::covers(cloud.bounds(), 1));
    EXPECT_FALSE(CellLayout::covers(cloud.bounds(), 0.9));
    EXPECT_TRUE(CellLayout::covers(cloud.bounds(), CellLayout::coveringSize(cloud.bounds(), 1e-7)));
    EXPECT_EQ(CellLayout::coveringSize(cloud.bounds(), 3), 3);
    const CellGrid grid(cloud, 1, {});
    ASSERT_EQ(grid.cellCount(), 2U);
    EXPECT_EQ(grid.corner(1), Eigen::Vector3d(2097148, 0, 0));
}

TEST(NearbyPoints, HoldEveryPointWithinTheRadius) {
    const auto points = roughScene(4000, {1000, -2000, 0});
    const PointCloud cloud = cloudOf(points, {1000, -2000, 0});
    const double radius = 0.15;
    std::vector<std::size_t> expected(cloud.size(), 0);
    for (std::size_t i = 0; i < points.size(); ++i)
        for (const Eigen::Vector3d& other : points)
            expected[i] += (other - points[i]).squaredNorm() <= radius * radius;
    std::vector<std::size_t> found(cloud.size(), 0);
    forNearbyPoints(cloud, radius, "test", {}, [&](const NearbyPoints& nearby) {
        ASSERT_EQ(nearby.x.size() % NearbyPoints::kLanes, 0U);
        for (std::size_t i = 0; i < nearby.own.size(); ++i) {
            const std::size_t self = nearby.firstOwn + i;
            for (std::size_t at = 0; at < nearby.x.size(); ++at) {
                const Eigen::Vector3d apart(nearby.x[at] - nearby.x[self], nearby.y[at] - nearby.y[self],
                                            nearby.z[at] - nearby.z[self]);
                found[nearby.own[i]] += apart.squaredNorm() <= radius * radius;
            }
        }
    });
    EXPECT_EQ(found, expected);
}
