#include <gtest/gtest.h>

#include <cmath>

#include "core/measurement/fit/ExtremeFit.h"
#include "core/measurement/fit/FittedLength.h"
#include "core/measurement/fit/Snap.h"
#include "tests/core/measurement/fit/FitClouds.h"

namespace vestige {
namespace {

using Vec = Eigen::Vector3d;
using fit_test::Cloud;
using fit_test::kOrigin;
using fit_test::request;

constexpr double kNoise = 0.03;
const Vec kDown(0, 0, -1);

TEST(SurfaceFit, OfAFlatSurfaceItIsTheMeanWithTheUncertaintyItSays) {
    int within = 0;
    double squares = 0;
    constexpr int kTrials = 200;
    for (int trial = 0; trial < kTrials; ++trial) {
        Cloud cloud(2000 + trial, kNoise);
        cloud.patch({-0.5, -0.5, 0}, {1, 0, 0}, {0, 1, 0}, 15000, kDown);
        const auto octree = cloud.octree();
        const Vec seed(0.003, -0.002, cloud.random().normal(0, kNoise));
        const auto feature = snapFeature(request(*octree, seed, kNoise), SnapMode::surface);
        ASSERT_TRUE(feature) << feature.error().sentence();
        const double error = feature->position.z() - kOrigin.z();
        squares += error * error;
        within += error * error <= 4 * feature->covariance(2, 2) ? 1 : 0;
        // Across the view it stays on the line of sight.
        EXPECT_NEAR(feature->position.x() - kOrigin.x(), 0.003, 1e-6);
        EXPECT_NEAR(feature->position.y() - kOrigin.y(), -0.002, 1e-6);
    }
    EXPECT_LT(std::sqrt(squares / kTrials), 0.4 * kNoise);
    EXPECT_GT(within, 0.9 * kTrials);
}

TEST(SurfaceFit, ManyPointsAreNoCertainty) {
    for (const std::size_t count : {100U, 5000U, 200000U}) {
        const auto end = meanUpperEnd(std::vector<double>(count, 1.25), kNoise);
        ASSERT_TRUE(end);
        // No finer than the places that are tried.
        EXPECT_GE(end->standardUncertainty, 0.1 * kNoise / std::sqrt(12.0) * (1 - 1e-9)) << count;
        EXPECT_LT(end->standardUncertainty, kNoise) << count;
    }
}

TEST(SurfaceFit, OfAHandleBeforeItsDoorItIsTheHandle) {
    // The beam's spot is wider than the handle: echoes lie anywhere between it and the door.
    constexpr double kProud = 0.06;
    double sum = 0;
    double middle = 0;
    constexpr int kTrials = 60;
    for (int trial = 0; trial < kTrials; ++trial) {
        Cloud cloud(3000 + trial, 0.02);
        for (int i = 0; i < 2500; ++i)
            cloud.add({cloud.random().uniform(-0.2, 0.2), cloud.random().uniform(-0.1, 0.1),
                       kProud * cloud.random().uniform()},
                      kDown);
        const auto octree = cloud.octree();
        const Vec seed(0, 0, 0.5 * kProud + cloud.random().normal(0, 0.03));
        const auto feature = snapFeature(request(*octree, seed, 0.02), SnapMode::surface);
        ASSERT_TRUE(feature) << feature.error().sentence();
        sum += feature->position.z() / kTrials;
        middle += 0.5 * kProud / kTrials;
    }
    EXPECT_NEAR(sum, kProud, 0.012);
    EXPECT_GT(sum, middle + 0.015);
}

TEST(SurfaceFit, SaysThatNothingIsSeenWhereTooFewPointsLie) {
    Cloud cloud(9, 0.001);
    cloud.patch({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 40, kDown);
    const auto octree = cloud.octree();
    auto asked = request(*octree, {5, 5, 0}, 0.001);
    asked.radius_m = 10;
    const auto feature = snapFeature(asked, SnapMode::surface);
    ASSERT_FALSE(feature);
    EXPECT_NE(feature.error().sentence().find("no surface was found"), std::string::npos);
}

TEST(SurfaceFit, DepthWrongAtBothEndsCountsWhereLinesOfSightPart) {
    const auto end = [](double x, double eye) {
        FittedEnd made{{x, 0, 0}, {.mode = SnapMode::surface}};
        made.feature.position = made.pick;
        made.feature.axis = Vec(eye - x, 0, 2).normalized();
        made.feature.rms = kNoise;
        return made;
    };
    // From one eye 2 m away, 0.6 m look 0.6 * 0.03 / 2 m longer at a depth wrong by 0.03 m.
    const FittedLength near = fittedLength(end(-0.3, 0), end(0.3, 0));
    EXPECT_NEAR(near.length_m, 0.6, 1e-12);
    EXPECT_NEAR(std::sqrt(near.variance_m2), 0.009, 0.0002);
    const FittedLength parallel = fittedLength(end(-0.3, -0.3), end(0.3, 0.3));
    EXPECT_NEAR(parallel.variance_m2, 0, 1e-12);
}

}  // namespace
}  // namespace vestige
