#include "core/geometry/NeighbourIndex.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/Parallel.h"
#include "core/base/Random.h"
#include "core/geometry/NeighbourLists.h"

using namespace vestige;
using Neighbour = NeighbourIndex::Neighbour;

namespace {

/// A rough surface with strays far off, a lattice (many equal distances) and points that coincide.
std::vector<Eigen::Vector3f> mixedPoints(std::size_t count) {
    Random random(5);
    std::vector<Eigen::Vector3f> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = random.uniform(-20, 20);
        const double y = random.uniform(-20, 20);
        points.push_back(Eigen::Vector3d(x, y, std::sin(x) + 0.01 * random.normal()).cast<float>());
    }
    for (int i = 0; i < 500; ++i)
        points.emplace_back(static_cast<float>(i % 8), static_cast<float>(i / 8 % 8),
                            static_cast<float>(i / 64));
    for (int i = 0; i < 150; ++i) points.emplace_back(0.5F, 0.25F, 0.0F);
    points.emplace_back(1e6F, -3e5F, 2e4F);
    points.emplace_back(-7e4F, 0.0F, 0.0F);
    return points;
}

std::vector<Neighbour> allByDistance(const std::vector<Eigen::Vector3f>& points,
                                     const Eigen::Vector3f& centre) {
    std::vector<Neighbour> all;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector3f d = points[i] - centre;
        all.push_back({i, d.x() * d.x() + d.y() * d.y() + d.z() * d.z()});
    }
    std::sort(all.begin(), all.end(), NeighbourIndex::nearer);
    return all;
}

}  // namespace

TEST(NeighbourIndex, AnswersAsSearchingThroughAllPointsDoes) {
    const auto points = mixedPoints(3000);
    const NeighbourIndex index(points);
    ASSERT_EQ(index.size(), points.size());
    Random random(8);
    std::vector<Neighbour> found;
    for (int trial = 0; trial < 300; ++trial) {
        Eigen::Vector3f centre = points[static_cast<std::size_t>(random.uniform(0, 1) * 3600)];
        if (trial % 3 == 0)
            centre += Eigen::Vector3d(random.normal(), random.normal(), random.normal()).cast<float>();
        const auto all = allByDistance(points, centre);
        for (const std::size_t count : {1U, 7U, 40U, 5000U}) {
            index.nearest(centre, count, found);
            const std::size_t many = std::min(count, points.size());
            ASSERT_EQ(found, std::vector<Neighbour>(all.begin(), all.begin() + static_cast<long>(many)));
        }
        ASSERT_EQ(index.closest(centre, 1e12F), all.front());
        ASSERT_EQ(index.closest(centre, all.front().squaredDistance), all.front());
        if (all.front().squaredDistance > 0) {
            ASSERT_FALSE(index.closest(centre, 0.9F * all.front().squaredDistance));
        }
        for (const float radius : {0.0F, 0.5F, 3.0F}) {
            std::vector<Neighbour> expected;
            for (const Neighbour& one : all)
                if (one.squaredDistance <= radius * radius) expected.push_back(one);
            std::sort(expected.begin(), expected.end(),
                      [](const Neighbour& a, const Neighbour& b) { return a.point < b.point; });
            index.radiusSearch(centre, radius, found);
            ASSERT_EQ(found, expected);
        }
    }
}

TEST(NeighbourIndex, AllPointsAtOnceGiveTheSameAsOneByOne) {
    const auto points = mixedPoints(2500);
    const NeighbourIndex index(points);
    for (const std::size_t count : {1U, 2U, 9U, 21U, 32U, 33U, 70U}) {
        std::vector<std::vector<Neighbour>> lists(points.size());
        forNearest(index, count, [&](std::uint32_t point, std::span<const Neighbour> nearest) {
            EXPECT_TRUE(lists[point].empty());
            lists[point].assign(nearest.begin(), nearest.end());
        });
        std::vector<std::vector<float>> distances(points.size());
        forNearestDistances(index, count, [&](const NearestDistances& nearest) {
            for (std::size_t lane = 0; lane < nearest.points.size(); ++lane)
                for (const auto& row : nearest.squared) distances[nearest.points[lane]].push_back(row[lane]);
        });
        for (std::size_t i = 0; i < points.size(); ++i) {
            std::vector<Neighbour> one;
            index.nearest(points[i], count, one);
            ASSERT_EQ(lists[i], one) << i << " of " << count;
            ASSERT_EQ(distances[i].size(), count);
            for (std::size_t j = 0; j < count; ++j) ASSERT_EQ(distances[i][j], one[j].squaredDistance);
        }
    }
}

TEST(NeighbourIndex, IsTheSameForAnyThreads) {
    const auto points = mixedPoints(40000);
    const auto answers = [&] {
        const NeighbourIndex index(points);
        std::vector<float> sums(points.size());
        forNearestDistances(index, 12, [&](const NearestDistances& nearest) {
            for (std::size_t lane = 0; lane < nearest.points.size(); ++lane)
                for (const auto& row : nearest.squared) sums[nearest.points[lane]] += row[lane];
        });
        return sums;
    };
    setThreadCount(1);
    const auto one = answers();
    for (const int threads : {2, 7}) {
        setThreadCount(threads);
        EXPECT_EQ(answers(), one);
    }
    setThreadCount(0);
}

TEST(NeighbourIndex, FewPointsGiveInfiniteRows) {
    const std::vector<Eigen::Vector3f> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
    std::size_t seen = 0;
    forNearestDistances(NeighbourIndex(points), 5, [&](const NearestDistances& nearest) {
        seen += nearest.points.size();
        for (std::size_t lane = 0; lane < nearest.points.size(); ++lane) {
            EXPECT_EQ(nearest.squared[0][lane], 0);
            EXPECT_EQ(nearest.squared[1][lane], 1);
            EXPECT_EQ(nearest.squared[3][lane], std::numeric_limits<float>::infinity());
        }
    });
    EXPECT_EQ(seen, 3U);
    const NeighbourIndex none{std::span<const Eigen::Vector3f>()};
    EXPECT_FALSE(none.closest({0, 0, 0}, 1));
    forNearest(none, 3, [&](std::uint32_t, std::span<const Neighbour>) { FAIL(); });
}
