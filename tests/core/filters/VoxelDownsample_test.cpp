#include "core/filters/VoxelDownsample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

#include "core/base/Parallel.h"
#include "tests/core/filters/FilterClouds.h"

using namespace vestige;
using namespace vestige::test;

namespace {

using Voxel = std::array<double, 3>;

Voxel voxelOf(const Eigen::Vector3d& world, double size) {
    const double perSize = 1 / size;
    return {std::floor(world.x() * perSize), std::floor(world.y() * perSize),
            std::floor(world.z() * perSize)};
}

std::map<Voxel, std::vector<std::size_t>> voxelsOf(const std::vector<Eigen::Vector3d>& points, double size) {
    std::map<Voxel, std::vector<std::size_t>> voxels;
    for (std::size_t i = 0; i < points.size(); ++i) voxels[voxelOf(points[i], size)].push_back(i);
    return voxels;
}

}  // namespace

TEST(VoxelDownsample, AKnownCubeGivesItsVoxels) {
    // 8 x 8 x 8 points, a quarter of a voxel apart and off its faces: 2 x 2 x 2 voxels of 64 points.
    std::vector<Eigen::Vector3d> points;
    for (int x = 0; x < 8; ++x)
        for (int y = 0; y < 8; ++y)
            for (int z = 0; z < 8; ++z)
                points.emplace_back(0.125 + 0.25 * x, 10.125 + 0.25 * y, -1.875 + 0.25 * z);
    const auto thin = downsample(cloudOf(points), 1);
    ASSERT_TRUE(thin);
    ASSERT_EQ(thin->size(), 8U);
    for (std::size_t i = 0; i < 8; ++i)
        EXPECT_EQ(thin->point(i),
                  Eigen::Vector3d(0.5 + static_cast<double>(i / 4), 10.5 + static_cast<double>(i / 2 % 2),
                                  -1.5 + static_cast<double>(i % 2)));
    const auto measured = downsample(cloudOf(points), 1, VoxelRepresentative::nearest);
    ASSERT_TRUE(measured);
    // Eight points are equally near to the middle; the first of them stands for the voxel.
    EXPECT_EQ(measured->point(0), Eigen::Vector3d(0.375, 10.375, -1.625));
}

TEST(VoxelDownsample, OnePointInEveryVoxelThatHoldsPointsAndNoOther) {
    const auto points = roughScene(30000, {-7, 3, 1});
    const PointCloud cloud = cloudOf(points);
    for (const double size : {0.07, 0.2, 1.3}) {
        const auto voxels = voxelsOf(points, size);
        const auto centroids = downsample(cloud, size);
        const auto nearest = downsample(cloud, size, VoxelRepresentative::nearest);
        ASSERT_TRUE(centroids && nearest);
        ASSERT_EQ(centroids->size(), voxels.size());
        ASSERT_EQ(nearest->size(), voxels.size());
        std::size_t i = 0;
        for (const auto& [voxel, members] : voxels) {
            Eigen::Vector3d mean = Eigen::Vector3d::Zero();
            for (const std::size_t member : members)
                mean += points[member] / static_cast<double>(members.size());
            ASSERT_LT((centroids->point(i) - mean).norm(), 1e-6);
            ASSERT_EQ(voxelOf(nearest->point(i), size), voxel);
            double least = 1e9;
            for (const std::size_t member : members) least = std::min(least, (points[member] - mean).norm());
            ASSERT_NEAR((nearest->point(i) - mean).norm(), least, 1e-9);
            ++i;
        }
    }
}

TEST(VoxelDownsample, ManyChunksOfAFarCloudAreThoseOfAMap) {
    // Over two chunks of 65 536 points, and so far from the origin that offsets need residuals.
    const Eigen::Vector3d origin(483000, 4375000, 0);
    auto points = roughScene(150000, {483700, 4375661, 35});
    points.emplace_back(dyadic({482500, 4375001, 30}));
    PointCloudBuilder builder(origin);
    for (const Eigen::Vector3d& point : points) {
        builder.attributes().intensity.push_back(static_cast<float>(builder.size()));
        builder.add(point);
    }
    const PointCloud cloud = std::move(builder).build();
    ASSERT_FALSE(cloud.residuals().empty());
    const double size = 0.5;
    const auto voxels = voxelsOf(points, size);
    setThreadCount(2);
    const auto bare = downsample(cloud.withAttributes({}), size);
    const auto averaged = downsample(cloud, size);
    const auto nearest = downsample(cloud, size, VoxelRepresentative::nearest);
    setThreadCount(0);
    ASSERT_TRUE(bare && averaged && nearest);
    ASSERT_EQ(bare->size(), voxels.size());
    ASSERT_EQ(nearest->size(), voxels.size());
    EXPECT_FALSE(bare->residuals().empty());
    std::size_t i = 0;
    for (const auto& [voxel, members] : voxels) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        double indices = 0;
        for (const std::size_t member : members) {
            sum += points[member] - points[members.front()];
            indices += static_cast<double>(member);
        }
        const auto count = static_cast<double>(members.size());
        const Eigen::Vector3d mean = points[members.front()] + sum / count;
        ASSERT_LT((bare->point(i) - mean).norm(), 1e-7);
        ASSERT_EQ(averaged->point(i), bare->point(i));
        ASSERT_NEAR(static_cast<double>(averaged->attributes().intensity[i]), indices / count, 0.01);
        double least = 1e9;
        for (const std::size_t member : members) least = std::min(least, (points[member] - mean).norm());
        ASSERT_NEAR((nearest->point(i) - mean).norm(), least, 1e-8);
        const auto chosen = static_cast<std::size_t>(nearest->attributes().intensity[i]);
        ASSERT_EQ(nearest->point(i), points[chosen]);
        ++i;
    }
}

TEST(VoxelDownsample, IsTheSameForAnyThreadsOriginAndOrder) {
    auto points = roughScene(140000, {483400, 4375661, 35});
    setThreadCount(1);
    const PointCloud cloud = cloudOf(points, {483400, 4375661, 35});
    const auto one = downsample(cloud, 0.2);
    const auto oneNearest = downsample(cloud, 0.2, VoxelRepresentative::nearest);
    ASSERT_TRUE(one && oneNearest);
    for (const int threads : {2, 7}) {
        setThreadCount(threads);
        expectIdentical(*one, *downsample(cloud, 0.2));
        expectIdentical(*oneNearest, *downsample(cloud, 0.2, VoxelRepresentative::nearest));
    }
    setThreadCount(0);
    const PointCloud moved = cloudOf(points, {483500.5, 4375600.25, 0});
    expectIdentical(*oneNearest, *downsample(moved, 0.2, VoxelRepresentative::nearest));
    const auto elsewhere = downsample(moved, 0.2);
    ASSERT_EQ(elsewhere->size(), one->size());
    std::reverse(points.begin(), points.end());
    const auto reversed = downsample(cloudOf(points, {483400, 4375661, 35}), 0.2);
    ASSERT_EQ(reversed->size(), one->size());
    for (std::size_t i = 0; i < one->size(); ++i) {
        // A float offset of up to 128 m holds 8 micrometres.
        ASSERT_LT((elsewhere->point(i) - one->point(i)).norm(), 2e-5);
        ASSERT_LT((reversed->point(i) - one->point(i)).norm(), 1e-6);
    }
}

TEST(VoxelDownsample, AveragesQuantitiesAndVotesOnLabels) {
    PointCloudBuilder builder(Eigen::Vector3d::Zero());
    for (int i = 0; i < 5; ++i) builder.add({0.1 + 0.1 * i, 0.5, 0.5});
    builder.add({1.5, 0.5, 0.5});
    PointAttributes& attributes = builder.attributes();
    attributes.intensity = {1, 2, 3, 4, 10, 7};
    attributes.color = {{0, 0, 65535}, {0, 1, 65535}, {0, 0, 65535}, {0, 0, 65535}, {5, 2, 65535}, {9, 9, 9}};
    attributes.classification = {6, 2, 6, 2, 5, 1};
    attributes.gpsTime = {3e8, 3e8 + 1e-6, 3e8 + 2e-6, 3e8 + 1e-6, 3e8 + 1e-6, 1};
    attributes.normal = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 1, 0}, {0, 1, 0}, {0, 0, 1}};
    attributes.pointSource = {3, 3, 9, 9, 9, 1};
    const PointCloud cloud = std::move(builder).build();

    const auto mean = downsample(cloud, 1);
    ASSERT_TRUE(mean);
    ASSERT_EQ(mean->size(), 2U);
    EXPECT_EQ(mean->attributes().intensity, (std::vector<float>{4, 7}));
    EXPECT_EQ(mean->attributes().color[0], (Color{1, 1, 65535}));
    EXPECT_EQ(mean->attributes().classification[0], 2);
    EXPECT_NEAR(mean->attributes().gpsTime[0] - 3e8, 1e-6, 6e-8);
    EXPECT_EQ(mean->attributes().normal[0], Eigen::Vector3f(0, 1, 0));
    EXPECT_EQ(mean->attributes().pointSource[0], 9);
    EXPECT_TRUE(mean->attributes().returnNumber.empty());

    const auto measured = downsample(cloud, 1, VoxelRepresentative::nearest);
    ASSERT_TRUE(measured);
    EXPECT_EQ(measured->attributes().intensity, (std::vector<float>{3, 7}));
    EXPECT_EQ(measured->attributes().classification[0], 6);
}

TEST(VoxelDownsample, LargeSitesDoNotOverflow) {
    // 100 km at 0.1 m: 10^18 voxels, far over 32 bits.
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 1000; ++i) {
        points.emplace_back(100.0 * i + 0.03, -100.0 * i + 0.03, i + 0.03);
        points.emplace_back(100.0 * i + 0.07, -100.0 * i + 0.07, i + 0.07);
    }
    const auto thin = downsample(cloudOf(points), 0.1);
    ASSERT_TRUE(thin);
    ASSERT_EQ(thin->size(), 1000U);
    for (int i = 0; i < 1000; ++i)
        ASSERT_LT((thin->point(static_cast<std::size_t>(i)) -
                   Eigen::Vector3d(100.0 * i + 0.05, -100.0 * i + 0.05, i + 0.05))
                      .norm(),
                  1e-4);
}

TEST(VoxelDownsample, RefusesSizesThatCannotBe) {
    const PointCloud cloud = cloudOf({{0, 0, 0}, {1000, 0, 0}});
    for (const double size : {0.0, -1.0, std::nan(""), 1e-4}) {
        const auto refused = downsample(cloud, size);
        ASSERT_FALSE(refused) << size;
        EXPECT_EQ(refused.error().code, ErrorCode::usage);
    }
    EXPECT_NE(downsample(cloud, 1e-4).error().sentence().find("1000 long"), std::string::npos);
    EXPECT_TRUE(downsample(PointCloud(), 0.2)->empty());
}

TEST(VoxelDownsample, LevelsAreEachTheCloudAtItsSize) {
    const PointCloud cloud = cloudOf(roughScene(20000, {0, 0, 0}));
    const auto levels = downsampleLevels(cloud, 0.2, 0.2 / (0.8 * 0.8 * 0.8), VoxelRepresentative::centroid);
    ASSERT_TRUE(levels);
    ASSERT_EQ(levels->size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR((*levels)[i].size, 0.2 * std::pow(1 / 0.8, static_cast<double>(i)), 1e-12);
        expectIdentical((*levels)[i].cloud, *downsample(cloud, (*levels)[i].size));
        if (i > 0) {
            EXPECT_LT((*levels)[i].cloud.size(), (*levels)[i - 1].cloud.size());
        }
    }
    EXPECT_FALSE(downsampleLevels(cloud, 0.2, 0.1, VoxelRepresentative::centroid));
}

TEST(VoxelDownsample, StopsWhenCancelled) {
    const PointCloud cloud = cloudOf(roughScene(50000, {0, 0, 0}));
    JobControl control;
    control.cancel();
    const auto stopped = downsample(cloud, 0.2, VoxelRepresentative::centroid, control);
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
}
