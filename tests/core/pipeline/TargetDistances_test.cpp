#include "core/pipeline/TargetDistances.h"

#include <cmath>
#include <cstring>

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

TEST_F(TargetDistancesTest, AreNegativeBelow) {
    PointCloudBuilder builder;
    for (int i = 0; i < 50; ++i)
        builder.add(corner + Eigen::Vector3d(0.6 + 0.013 * i, 1.1, i % 2 == 0 ? 0.012 : -0.007));
    const auto distances = targetDistances(target, {}, std::move(builder).build(), {});
    for (std::size_t i = 0; i < distances.size(); ++i)
        EXPECT_NEAR(distances[i], i % 2 == 0 ? 0.012 : -0.007, 1e-4);
}

TEST_F(TargetDistancesTest, AreNothingBesideTheTarget) {
    PointCloudBuilder builder;
    builder.add(corner + Eigen::Vector3d(2.9, 0.5, 0));
    const auto distances = targetDistances(target, {}, std::move(builder).build(), {});
    EXPECT_TRUE(std::isnan(distances.front())) << "the plane goes on there, but the target does not";
}

TEST_F(TargetDistancesTest, ArePositiveOutsideOfUprightSurfaces) {
    // Four walls of a box of 4 m; the source stands round the same middle, 2 cm larger.
    PointCloudBuilder walls;
    PointCloudBuilder larger;
    for (int side = 0; side < 4; ++side)
        for (int along = 0; along < 60; ++along)
            for (int up = 0; up < 30; ++up) {
                const double angle = 0.5 * M_PI * side;
                const auto at = [&](double out) {
                    const Eigen::Vector2d place =
                        Eigen::Rotation2Dd(angle) * Eigen::Vector2d(out, 0.06 * along - 1.77);
                    return Eigen::Vector3d(corner + Eigen::Vector3d(place.x(), place.y(), 0.06 * up));
                };
                walls.add(at(2));
                if (along > 5 && along < 55 && up > 5 && up < 25) larger.add(at(2.02));
            }
    const Octree box(std::make_shared<const PointCloud>(std::move(walls).build()));
    for (const float distance : targetDistances(box, {}, std::move(larger).build(), {}))
        EXPECT_NEAR(distance, 0.02, 1e-4);
}

TEST_F(TargetDistancesTest, FindTheSurfaceUnderItsNoise) {
    // Points 2 cm apart with 2 cm of noise: eight of them make no plane, more do.
    PointCloudBuilder noisy;
    std::uint64_t state = 12345;
    const auto uniform = [&state] {
        state = state * 6364136223846793005U + 1442695040888963407U;
        return static_cast<double>(state >> 33) / 2147483648.0 - 0.5;
    };
    for (int x = 0; x < 200; ++x)
        for (int y = 0; y < 200; ++y) {
            const double noise = 0.02 * 2 * (uniform() + uniform() + uniform());
            noisy.add(corner + Eigen::Vector3d(0.02 * x, 0.02 * y, noise));
        }
    const Octree surface(std::make_shared<const PointCloud>(std::move(noisy).build()));
    PointCloudBuilder builder;
    for (int i = 0; i < 400; ++i)
        builder.add(corner + Eigen::Vector3d(0.6 + 0.12 * (i % 20), 0.6 + 0.12 * (i / 20), 0.05));
    const auto distances = targetDistances(surface, {}, std::move(builder).build(), {});
    double sum = 0;
    int known = 0;
    for (const float distance : distances)
        if (std::isfinite(distance)) {
            sum += distance;
            ++known;
        }
    EXPECT_GT(known, 200);
    EXPECT_NEAR(sum / known, 0.05, 0.005);
}

TEST_F(TargetDistancesTest, CanBeCancelled) {
    const JobControl control;
    control.cancel();
    EXPECT_TRUE(targetDistances(target, {}, target.cloud(), {}, control).empty());
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
    const auto seven = targetDistances(target, {}, source, {});
    ASSERT_EQ(one.size(), seven.size());
    EXPECT_EQ(std::memcmp(one.data(), seven.data(), one.size() * sizeof(float)), 0) << "NaN included";
    setThreadCount(0);
}

}  // namespace
}  // namespace vestige
