#include "core/filters/Outliers.h"

#include <gtest/gtest.h>

#include "core/base/Parallel.h"
#include "tests/core/filters/FilterClouds.h"

using namespace vestige;
using namespace vestige::test;

namespace {

constexpr std::size_t kEvery = 500;

/// A floor of 5 cm spacing in which every 500th point hangs alone in the air; intensity is the index.
PointCloud floorWithBirds() {
    Random random(9);
    PointCloudBuilder builder(Eigen::Vector3d(1000, 2000, 0));
    for (std::size_t i = 0; i < 20000; ++i) {
        const double height = i % kEvery == 0 ? random.uniform(2, 6) : 0.01 * random.normal();
        builder.add(dyadic({1000 + random.uniform(0, 7), 2000 + random.uniform(0, 7), height}));
        builder.attributes().intensity.push_back(static_cast<float>(i));
    }
    return std::move(builder).build();
}

}  // namespace

TEST(Outliers, BothMethodsDropTheBirdsAndKeepTheFloor) {
    const PointCloud cloud = floorWithBirds();
    OutlierOptions radius;
    radius.method = OutlierMethod::radius;
    radius.radius = 0.25;
    radius.minimumNeighbours = 3;
    OutlierOptions statistical;
    statistical.method = OutlierMethod::statistical;
    for (const OutlierOptions& options : {radius, statistical}) {
        const auto kept = removeOutliers(cloud, options);
        ASSERT_TRUE(kept);
        EXPECT_GT(kept->size(), cloud.size() - cloud.size() / kEvery - 20);
        float before = -1;
        for (std::size_t i = 0; i < kept->size(); ++i) {
            const float index = kept->attributes().intensity[i];
            ASSERT_GT(index, before);
            before = index;
            ASSERT_NE(static_cast<std::size_t>(index) % kEvery, 0U);
            ASSERT_EQ(kept->point(i), cloud.point(static_cast<std::size_t>(index)));
        }
    }
}

TEST(Outliers, RadiusCountsTheOthersWithinIt) {
    // Four points in a row, 1 apart: the ends have one neighbour, the inner ones two.
    const PointCloud row = cloudOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
    OutlierOptions options;
    options.method = OutlierMethod::radius;
    options.radius = 1;
    options.minimumNeighbours = 1;
    EXPECT_EQ(removeOutliers(row, options)->size(), 4U);
    options.minimumNeighbours = 2;
    const auto inner = removeOutliers(row, options);
    ASSERT_EQ(inner->size(), 2U);
    EXPECT_EQ(inner->point(0), Eigen::Vector3d(1, 0, 0));
    options.minimumNeighbours = 3;
    EXPECT_TRUE(removeOutliers(row, options)->empty());
}

TEST(Outliers, StatisticalLimitIsMeanPlusSigmasOfTheNeighbourDistances) {
    // Distances to the nearest other: 1, 1, 1, 5. Mean 2, SD 2 (n - 1).
    const PointCloud row = cloudOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {7, 0, 0}});
    OutlierOptions options;
    options.method = OutlierMethod::statistical;
    options.neighbours = 1;
    options.sigmas = 1.51;
    EXPECT_EQ(removeOutliers(row, options)->size(), 4U);
    options.sigmas = 1.49;
    EXPECT_EQ(removeOutliers(row, options)->size(), 3U);
}

TEST(Outliers, AreTheSameForAnyThreads) {
    const PointCloud cloud = floorWithBirds();
    for (const OutlierMethod method : {OutlierMethod::statistical, OutlierMethod::radius}) {
        OutlierOptions options;
        options.method = method;
        setThreadCount(1);
        const auto one = removeOutliers(cloud, options);
        ASSERT_TRUE(one);
        EXPECT_LT(one->size(), cloud.size());
        for (const int threads : {2, 7}) {
            setThreadCount(threads);
            expectIdentical(*one, *removeOutliers(cloud, options));
        }
        setThreadCount(0);
    }
}

TEST(Outliers, RefusesNumbersThatMeanNothingAndStopsWhenCancelled) {
    const PointCloud cloud = floorWithBirds();
    OutlierOptions options;
    options.method = OutlierMethod::statistical;
    JobControl control;
    control.cancel();
    EXPECT_EQ(removeOutliers(cloud, options, control).error().code, ErrorCode::cancelled);
    options.neighbours = 0;
    EXPECT_EQ(removeOutliers(cloud, options).error().code, ErrorCode::usage);
    options = {};
    options.method = OutlierMethod::radius;
    options.radius = -2;
    EXPECT_EQ(removeOutliers(cloud, options).error().code, ErrorCode::usage);
}
