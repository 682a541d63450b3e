#include "core/geometry/Octree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/Parallel.h"
#include "core/base/Random.h"
#include "core/geometry/PointCloudBuilder.h"

using namespace vestige;

namespace {

std::shared_ptr<const PointCloud> shared(PointCloudBuilder builder) {
    return std::make_shared<const PointCloud>(std::move(builder).build());
}

/// A wavy surface, some points in space, duplicates and one far outlier.
std::shared_ptr<const PointCloud> mixedCloud(std::size_t count) {
    Random random(11);
    PointCloudBuilder builder(Eigen::Vector3d(500000, 4000000, 100));
    for (std::size_t i = 0; i < count; ++i) {
        const double x = random.uniform(0, 20);
        const double y = random.uniform(0, 15);
        builder.add(Eigen::Vector3d(500000 + x, 4000000 + y, 100 + std::sin(x) + 0.03 * random.normal()));
        if (i % 10 == 0) builder.add(Eigen::Vector3d(500000 + x, 4000000 + y, random.uniform(98, 110)));
        if (i % 50 == 0) builder.add(Eigen::Vector3d(500003, 4000003, 101));
    }
    builder.add(Eigen::Vector3d(500900, 4000000, 100));
    return shared(std::move(builder));
}

float squared(const Eigen::Vector3f& d) {
    return d.x() * d.x() + d.y() * d.y() + d.z() * d.z();
}

std::vector<Octree::Neighbour> allByDistance(const PointCloud& cloud, const Eigen::Vector3f& centre) {
    std::vector<Octree::Neighbour> all;
    for (std::uint32_t i = 0; i < cloud.size(); ++i) all.push_back({i, squared(cloud.offsets()[i] - centre)});
    std::stable_sort(all.begin(), all.end(),
                     [](const auto& a, const auto& b) { return a.squaredDistance < b.squaredDistance; });
    return all;
}

}  // namespace

TEST(Octree, NodesCoverTheirPointsOnceAndBoxesAreTight) {
    const auto cloud = mixedCloud(20000);
    const Octree octree(cloud, 16);
    std::vector<int> times(cloud->size(), 0);
    for (const std::uint32_t point : octree.order()) ++times[point];
    EXPECT_EQ(std::count(times.begin(), times.end(), 1), static_cast<std::ptrdiff_t>(cloud->size()));
    std::size_t inLeaves = 0;
    for (const Octree::Node& node : octree.nodes()) {
        Eigen::Vector3f min = cloud->offsets()[octree.order()[node.begin]];
        Eigen::Vector3f max = min;
        std::set<std::array<float, 3>> positions;
        for (std::uint32_t at = node.begin; at < node.end; ++at) {
            const Eigen::Vector3f& offset = cloud->offsets()[octree.order()[at]];
            min = min.cwiseMin(offset);
            max = max.cwiseMax(offset);
            if (node.childCount == 0) positions.insert({offset.x(), offset.y(), offset.z()});
        }
        ASSERT_EQ(node.min, min);
        ASSERT_EQ(node.max, max);
        if (node.childCount == 0) {
            inLeaves += node.end - node.begin;
            ASSERT_TRUE(node.end - node.begin <= 16 || positions.size() == 1);
            continue;
        }
        ASSERT_GE(node.childCount, 2);
        std::uint32_t at = node.begin;
        for (std::uint32_t child = 0; child < node.childCount; ++child) {
            ASSERT_EQ(octree.nodes()[node.firstChild + child].begin, at);
            at = octree.nodes()[node.firstChild + child].end;
        }
        ASSERT_EQ(at, node.end);
    }
    EXPECT_EQ(inLeaves, cloud->size());
}

TEST(Octree, SearchesAgreeWithBruteForce) {
    const auto cloud = mixedCloud(3000);
    const Octree octree(cloud);
    Random random(5);
    std::vector<Octree::Neighbour> found;
    for (int trial = 0; trial < 150; ++trial) {
        Eigen::Vector3f centre = cloud->offsets()[random.below(cloud->size())];
        if (trial % 3 == 0)
            centre += Eigen::Vector3d(random.normal(), random.normal(), random.normal()).cast<float>();
        if (trial % 50 == 0) centre = {3, 3, 1};
        const auto all = allByDistance(*cloud, centre);

        const auto radius = static_cast<float>(random.uniform(0, trial % 2 ? 0.5 : 8));
        std::vector<std::uint32_t> expected;
        for (const auto& one : all)
            if (one.squaredDistance <= radius * radius) expected.push_back(one.point);
        std::sort(expected.begin(), expected.end());
        octree.radiusSearch(centre, radius, found);
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) ASSERT_EQ(found[i].point, expected[i]);

        const std::size_t count = 1 + random.below(trial % 5 ? 40 : 4000);
        octree.nearest(centre, count, found);
        ASSERT_EQ(found.size(), std::min(count, cloud->size()));
        for (std::size_t i = 0; i < found.size(); ++i) {
            ASSERT_EQ(found[i].point, all[i].point) << trial << ' ' << i;
            ASSERT_EQ(found[i].squaredDistance, all[i].squaredDistance);
        }
    }
}

TEST(Octree, IsTheSameForAnyNumberOfThreads) {
    const auto cloud = mixedCloud(100000);
    setThreadCount(1);
    const Octree one(cloud);
    for (const int threads : {2, 7}) {
        setThreadCount(threads);
        const Octree other(cloud);
        EXPECT_TRUE(
            std::equal(one.order().begin(), one.order().end(), other.order().begin(), other.order().end()));
        ASSERT_EQ(one.nodes().size(), other.nodes().size());
        for (std::size_t i = 0; i < one.nodes().size(); ++i) {
            ASSERT_EQ(one.nodes()[i].begin, other.nodes()[i].begin);
            ASSERT_EQ(one.nodes()[i].firstChild, other.nodes()[i].firstChild);
            ASSERT_EQ(one.nodes()[i].min, other.nodes()[i].min);
        }
    }
    setThreadCount(0);
}

TEST(Octree, LocalSpacingIsThatOfAnEvenSampling) {
    PointCloudBuilder even;
    for (int x = 0; x < 60; ++x)
        for (int y = 0; y < 60; ++y) even.add(Eigen::Vector3d(0.05 * x, 0.05 * y, 2));
    const Octree grid(shared(std::move(even)));
    EXPECT_NEAR(grid.localSpacing(30 * 60 + 30), 0.05, 1e-6);

    Random random(8);
    PointCloudBuilder scattered;
    for (int i = 0; i < 40000; ++i)
        scattered.add(Eigen::Vector3d(random.uniform(0, 10), random.uniform(0, 10), 0));
    const Octree uneven(shared(std::move(scattered)));
    double sum = 0;
    for (std::uint32_t i = 0; i < 40000; ++i) sum += uneven.localSpacing(i);
    // Density 400 a square metre: 0.92 / sqrt(400).
    EXPECT_NEAR(sum / 40000, 0.9218 / 20, 0.0005);
}

TEST(Octree, SmallAndDegenerateCloudsHaveAnswers) {
    std::vector<Octree::Neighbour> found{{1, 1}};
    const Octree none(std::make_shared<const PointCloud>());
    EXPECT_TRUE(none.nodes().empty());
    none.radiusSearch({0, 0, 0}, 10, found);
    EXPECT_TRUE(found.empty());
    none.nearest({0, 0, 0}, 3, found);
    EXPECT_TRUE(found.empty());
    EXPECT_TRUE(none.coarse(5).empty());

    PointCloudBuilder single;
    single.add({1, 2, 3});
    EXPECT_EQ(Octree(shared(std::move(single))).localSpacing(0), 0);

    PointCloudBuilder same(Eigen::Vector3d::Zero());
    for (int i = 0; i < 200000; ++i) same.add({1, 2, 3});
    same.add({0, 0, 0});
    const Octree coincident(shared(std::move(same)));
    // Each answer without a look at all the others, which would take minutes.
    for (std::uint32_t i = 0; i < 200000; ++i) ASSERT_EQ(coincident.localSpacing(i), 0);
    coincident.nearest({0, 0, 0}, 3, found);
    ASSERT_EQ(found.size(), 3U);
    EXPECT_EQ(found[0].point, 200000U);
    EXPECT_EQ(found[1].point, 0U);
    EXPECT_EQ(found[2].point, 1U);
}

TEST(Octree, AFarStrayDoesNotCoarsenTheRest) {
    Random random(6);
    PointCloudBuilder builder(Eigen::Vector3d::Zero());
    builder.add({3e9, -1e9, 0});
    for (int i = 0; i < 20000; ++i)
        builder.add(Eigen::Vector3d(random.uniform(0, 10), random.uniform(0, 10), 0));
    const auto cloud = shared(std::move(builder));
    const Octree octree(cloud);
    for (const Octree::Node& node : octree.nodes())
        ASSERT_TRUE(node.childCount > 0 || node.end - node.begin <= 32);
    std::vector<Octree::Neighbour> found;
    for (std::uint32_t i = 1; i < 20000; i += 997) {
        const auto all = allByDistance(*cloud, cloud->offsets()[i]);
        octree.nearest(cloud->offsets()[i], 20, found);
        for (std::size_t k = 0; k < 20; ++k) ASSERT_EQ(found[k].point, all[k].point);
    }
}

TEST(Octree, CoarseIsSpreadOverTheWholeCloud) {
    const auto cloud = mixedCloud(20000);
    const Octree octree(cloud);
    const auto chosen = octree.coarse(600);
    ASSERT_EQ(chosen.size(), 600U);
    EXPECT_EQ(std::set<std::uint32_t>(chosen.begin(), chosen.end()).size(), 600U);
    int cells[4][3] = {};
    for (const std::uint32_t point : chosen) {
        const Eigen::Vector3d place = cloud->point(point) - cloud->origin();
        if (place.x() < 20) ++cells[static_cast<int>(place.x() / 5)][static_cast<int>(place.y() / 5)];
    }
    for (const auto& row : cells)
        for (const int many : row) EXPECT_GT(many, 25);
    EXPECT_EQ(octree.coarse(1U << 30).size(), cloud->size());
}
