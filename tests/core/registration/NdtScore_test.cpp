#include "core/registration/ndt/NdtScore.h"

#include <gtest/gtest.h>

#include <cmath>

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

/// The score as METHOD section 3 has it, in double and one point at a time.
double plainScore(const NormalDistributions& cells, const CentredSource& source, const Pose& pose) {
    double sum = 0;
    for (const Eigen::Vector3f& point : source.points) {
        const Eigen::Vector3d x = pose * point.cast<double>();
        const NormalCell* cell = cells.find(x.x(), x.y(), x.z());
        if (cell == nullptr) continue;
        const auto& c = cell->information;
        Eigen::Matrix3f inverse;
        inverse << c[0], c[1], c[2], c[1], c[3], c[4], c[2], c[4], c[5];
        const Eigen::Vector3d e = x - Eigen::Vector3d(cell->mean[0], cell->mean[1], cell->mean[2]);
        const double q = e.dot(inverse.cast<double>() * e);
        sum += static_cast<double>(cell->depth) * std::exp(-0.5 * static_cast<double>(cell->steepness) * q);
    }
    return sum / static_cast<double>(source.points.size());
}

TEST(NdtScore, IsThePlainScoreToFloatPrecision) {
    const std::vector<NormalDistributions> cells{target()};
    const CentredSource points = source(1003);
    const NdtScore score(cells, points);
    const double plain = plainScore(cells[0], points, start());
    ASSERT_LT(plain, -0.01);
    EXPECT_NEAR(score(start()).score, plain, 1e-5 * std::abs(plain));
    EXPECT_NEAR(score(start()).score, score.value(start()), 1e-6 * std::abs(plain));
    EXPECT_EQ(score(start()).inside, 1003U);
}

TEST(NdtScore, GradientAgreesWithFiniteDifferencesOfThePlainScore) {
    const std::vector<NormalDistributions> cells{target()};
    const CentredSource points = source();
    const ScoredPose here = NdtScore(cells, points)(start());
    ASSERT_EQ(here.inside, points.points.size());
    ASSERT_GT(here.gradient.cwiseAbs().minCoeff(), 1e-5);
    constexpr double h = 1e-4;
    const auto at = [&](const Vector6d& step) {
        return plainScore(cells[0], points, NdtScore::moved(start(), step, points.radius));
    };
    for (int i = 0; i < 6; ++i) {
        const Vector6d step = h * Vector6d::Unit(i);
        EXPECT_NEAR(here.gradient[i], (at(step) - at(-step)) / (2 * h), 1e-4 * here.gradient.norm())
            << "component " << i;
    }
}

TEST(NdtScore, HessianAgreesWithFiniteDifferencesOfThePlainScore) {
    const std::vector<NormalDistributions> cells{target()};
    const CentredSource points = source();
    const ScoredPose here = NdtScore(cells, points)(start());
    constexpr double h = 2e-3;
    const auto at = [&](const Vector6d& step) {
        return plainScore(cells[0], points, NdtScore::moved(start(), step, points.radius));
    };
    for (int i = 0; i < 6; ++i)
        for (int j = i; j < 6; ++j) {
            const Vector6d a = h * Vector6d::Unit(i), b = h * Vector6d::Unit(j);
            const double second = (at(a + b) - at(a - b) - at(b - a) + at(-a - b)) / (4 * h * h);
            EXPECT_NEAR(here.hessian(i, j), second, 2e-4 * here.hessian.norm()) << i << ' ' << j;
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
