#include "core/pipeline/TargetDistances.h"

#include <cmath>

#include <gtest/gtest.h>
#include "core/base/Parallel.h"
#include "core/geometry/PointCloudBuilder.h"

namespace vestige {
namespace {

/// A level grid of 2 m by 2 m with a point every 10 cm, far from the world's origin.
std::shared_ptr<const PointCloud> floorCloud(const Eigen::Vector3d& corner) {
    PointCloudBuilder builder;
    for (int x = 0; x < 20; ++x)
        for (int y = 0; y < 20; ++y) builder.add(corner + Eigen::Vector3d(0.1 * x, 0.1 * y, 0));
    return std::make_shared<const PointCloud>(std::move(builder).build());
}

class TargetDistancesTest : public testing::Test {
  protected:
    const Eigen::Vector3d corner{480000, 4375000, 30};
    Octree target{floorCloud(corner)};
};

TEST_F(TargetDistancesTest, MeasureAlongTheNormalOfAPlane) {
    // In millimetres, between the grid's points and 12 mm above it.
    PointCloudBuilder builder;
    for (int i = 0; i < 50; ++i) builder.add({1000 + 7.3 * i, 950 + 3.1 * i, 12});
    const PointCloud source = std::move(builder).build();
    Similarity place{Pose::Identity(), 0.001};
    place.pose.translation() = corner;
    for (const float distance : targetDistances(target, {}, source, place))
        EXPECT_NEAR(distance, 0.012, 1e-4);
}

TEST_F(TargetDistancesTest, MeasureToTheNearestPointBesideThePlane) {
    PointCloudBuilder builder;
    builder.add(corner + Eigen::Vector3d(2.9, 0.5, 0));
    const auto distances = targetDistances(target, {}, std::move(builder).build(), {});
    EXPECT_NEAR(distances.front(), 1.0, 1e-4) << "the plane goes on there, but the target does not";
}

TEST_F(TargetDistancesTest, AreTheSameForAnyNumberOfThreads) {
    PointCloudBuilder builder;
    for (int i = 0; i < 9000; ++i)
        builder.add(corner +
                    Eigen::Vector3d(std::fmod(0.37 * i, 2), std::fmod(0.11 * i, 2), 0.001 * (i % 40)));
    const PointCloud source = std::move(builder).build();
    setThreadCount(1);
    const auto one = targetDistances(target, {}, source, {});
    setThreadCount(7);
    EXPECT_EQ(targetDistances(target, {}, source, {}), one);
    setThreadCount(0);
}

}  // namespace
}  // namespace vestige
