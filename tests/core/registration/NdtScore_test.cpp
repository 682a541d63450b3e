#include "core/registration/ndt/NdtScore.h"

#include <gtest/gtest.h>

#include "core/base/Parallel.h"
#include "core/base/Random.h"

namespace vestige {
namespace {

/// Two voxels of 100 m that no step of these tests leaves, with points of every direction in them.
NormalDistributions target() {
    Random random(5);
    std::vector<Eigen::Vector3f> points;
    for (int i = 0; i < 200; ++i)
        points.push_back(
            Eigen::Vector3d(30 + random.normal(0, 4), 40 + random.normal(0, 1.5), 50 + random.normal(0, 2.5))
                .cast<float>());
    for (int i = 0; i < 200; ++i)
        points.push_back(
            Eigen::Vector3d(-30 + random.normal(0, 2), 40 + random.normal(0, 5), 50 + random.normal(0, 0.05))
                .cast<float>());
    const VoxelGrid grid(100);
    return {gatherPoints(points, grid), grid, {}};
}

CentredSource source(int count = 60) {
    Random random(6);
    CentredSource made;
    for (int i = 0; i < count; ++i)
        made.points.push_back(Eigen::Vector3d((i % 2 ? 30 : -30) + random.normal(0, 3), random.normal(0, 3),
                                              random.normal(0, 1))
                                  .cast<float>());
    made.radius = 20;
    return made;
}

Pose start() {
    Pose pose = Pose::Identity();
    pose.linear() = Eigen::AngleAxisd(0.03, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    pose.translation() << 0.4, 40.7, 50.2;
    return pose;
}

TEST(NdtScore, GradientAgreesWithFiniteDifferences) {
    const std::vector<NormalDistributions> cells{target()};
    const CentredSource points = source();
    const NdtScore score(cells, points);
    const ScoredPose here = score(start());
    ASSERT_EQ(here.inside, points.points.size());
    ASSERT_LT(here.score, -0.01);
    ASSERT_GT(here.gradient.cwiseAbs().minCoeff(), 1e-5);
    constexpr double h = 1e-4;
    for (int i = 0; i < 6; ++i) {
        const Vector6d step = h * Vector6d::Unit(i);
        const double slope = (score(NdtScore::moved(start(), step, points.radius)).score -
                              score(NdtScore::moved(start(), -step, points.radius)).score) /
                             (2 * h);
        EXPECT_NEAR(here.gradient[i], slope, 1e-6 * here.gradient.norm()) << "component " << i;
    }
}

TEST(NdtScore, HessianAgreesWithFiniteDifferencesOfTheScore) {
    const std::vector<NormalDistributions> cells{target()};
    const CentredSource points = source();
    const NdtScore score(cells, points);
    const ScoredPose here = score(start());
    constexpr double h = 2e-3;
    const auto at = [&](const Vector6d& step) {
        return score(NdtScore::moved(start(), step, points.radius)).score;
    };
    for (int i = 0; i < 6; ++i)
        for (int j = i; j < 6; ++j) {
            const Vector6d a = h * Vector6d::Unit(i), b = h * Vector6d::Unit(j);
            const double second = (at(a + b) - at(a - b) - at(b - a) + at(-a - b)) / (4 * h * h);
            EXPECT_NEAR(here.hessian(i, j), second, 2e-5 * here.hessian.norm()) << i << ' ' << j;
        }
    EXPECT_EQ(here.hessian, here.hessian.transpose());
}

TEST(NdtScore, IsTheSameBitsForAnyThreadCount) {
    const std::vector<NormalDistributions> cells{target()};
    const CentredSource points = source(20000);
    const NdtScore score(cells, points);
    setThreadCount(1);
    const ScoredPose one = score(start());
    for (const int threads : {2, 7}) {
        setThreadCount(threads);
        const ScoredPose many = score(start());
        EXPECT_EQ(one.score, many.score);
        EXPECT_EQ(one.gradient, many.gradient);
        EXPECT_EQ(one.hessian, many.hessian);
        EXPECT_EQ(one.inside, many.inside);
    }
    setThreadCount(0);
}

TEST(NdtScore, CountsAllPointsWhereverTheyAre) {
    const std::vector<NormalDistributions> cells{target()};
    CentredSource points = source();
    const double all = NdtScore(cells, points)(start()).score;
    const std::size_t count = points.points.size();
    for (std::size_t i = 0; i < count; ++i) points.points.emplace_back(5000.0F, 0.0F, 0.0F);
    const ScoredPose half = NdtScore(cells, points)(start());
    EXPECT_EQ(half.inside, count);
    EXPECT_NEAR(half.score, 0.5 * all, 1e-12);
}

TEST(NdtScore, FallsBackToTheLargerCell) {
    const std::vector<NormalDistributions> large{target()};
    const VoxelGrid fine(1);
    std::vector<NormalDistributions> both{target()};
    both.emplace_back(std::span<const CellMoments>{}, fine, DistributionOptions{});
    const CentredSource points = source();
    EXPECT_EQ(NdtScore(both, points)(start()).score, NdtScore(large, points)(start()).score);
}

}  // namespace
}  // namespace vestige
