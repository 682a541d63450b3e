#include "core/measurement/Length.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/Random.h"

using namespace vestige;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST(StudentQuantile, AgreesWithPublishedTables) {
    EXPECT_NEAR(studentQuantile975(1), 12.7062, 5e-5);
    EXPECT_NEAR(studentQuantile975(2), 4.30265, 5e-6);
    EXPECT_NEAR(studentQuantile975(3), 3.18245, 5e-6);
    EXPECT_NEAR(studentQuantile975(5), 2.57058, 5e-6);
    EXPECT_NEAR(studentQuantile975(10), 2.22814, 5e-6);
    EXPECT_NEAR(studentQuantile975(30), 2.04227, 5e-6);
    EXPECT_NEAR(studentQuantile975(120), 1.97993, 5e-6);
    EXPECT_NEAR(studentQuantile975(kInfinity), 1.95996, 5e-6);
}

TEST(StudentQuantile, TakesRealDegrees) {
    // Closed forms: nu = 1 is tan(pi (p - 1/2)), nu = 2 is (2p - 1) sqrt(2 / (4 p (1 - p))).
    EXPECT_NEAR(studentQuantile975(1), std::tan(std::acos(-1.0) * 0.475), 1e-9);
    EXPECT_NEAR(studentQuantile975(2), 0.95 * std::sqrt(2 / (4 * 0.975 * 0.025)), 1e-12);
    double last = kInfinity;
    for (double degrees = 0.5; degrees < 1e7; degrees *= 1.37) {
        const double t = studentQuantile975(degrees);
        EXPECT_LT(t, last) << degrees;
        EXPECT_GT(t, 1.959963984540) << degrees;
        last = t;
    }
    EXPECT_NEAR(studentQuantile975(1e12), 1.959963984540054, 1e-9);
    EXPECT_TRUE(std::isnan(studentQuantile975(0)));
}

TEST(Length, CombinesRepeatsEndsAndRegistration) {
    const std::array<double, 3> repeats{4.78, 4.80, 4.82};
    const EndUncertainty a{0.03, 0.024};
    const EndUncertainty b{0.0001, 0};
    const auto length = lengthStatistic(repeats, a, b, 0.01);
    ASSERT_TRUE(length);
    EXPECT_NEAR(length->mean_m, 4.80, 1e-12);
    ASSERT_TRUE(length->repeatSd_m);
    EXPECT_NEAR(*length->repeatSd_m, 0.02, 1e-12);
    const double u2 = 0.0004 / 3 + 0.0009 + 0.024 * 0.024 / 12 + 1e-8 + 0.0001;
    EXPECT_NEAR(*length->standardUncertainty_m, std::sqrt(u2), 1e-12);
    const double nu = u2 * u2 / (std::pow(0.0004 / 3, 2) / 2);
    EXPECT_NEAR(*length->degreesOfFreedom, nu, 1e-6 * nu);
    EXPECT_NEAR(*length->expandedUncertainty_m, studentQuantile975(nu) * std::sqrt(u2), 1e-12);
}

TEST(Length, RepeatsAloneHaveTheirOwnDegreesOfFreedom) {
    const std::array<double, 3> repeats{1.0, 1.1, 1.2};
    const auto length = lengthStatistic(repeats, {}, {});
    ASSERT_TRUE(length);
    EXPECT_NEAR(*length->degreesOfFreedom, 2, 1e-9);
    EXPECT_NEAR(*length->coverageFactor, 4.30265, 5e-6);
}

TEST(Length, EqualRepeatsLeaveTheNormalFactor) {
    const std::array<double, 3> repeats{2.0, 2.0, 2.0};
    const auto length = lengthStatistic(repeats, {0.03, 0}, {0.04, 0});
    ASSERT_TRUE(length);
    EXPECT_EQ(*length->repeatSd_m, 0);
    EXPECT_TRUE(std::isinf(*length->degreesOfFreedom));
    EXPECT_NEAR(*length->expandedUncertainty_m, 1.959963984540054 * 0.05, 1e-12);
}

TEST(Length, OneRepeatHasNoUncertaintyAndNoneNoLength) {
    const std::array<double, 1> one{2.5};
    const auto length = lengthStatistic(one, {0.03, 0}, {0.03, 0});
    ASSERT_TRUE(length);
    EXPECT_EQ(length->mean_m, 2.5);
    EXPECT_FALSE(length->repeatSd_m);
    EXPECT_FALSE(length->expandedUncertainty_m);
    EXPECT_FALSE(lengthStatistic({}, {}, {}));
}

TEST(Length, ExpandedUncertaintyCoversTheTruthNinetyFiveTimesInAHundred) {
    // Three repeats that scatter, nothing else: the case that k = 2 would cover only 82 % of.
    Random random(7);
    int covered = 0;
    int coveredByTwo = 0;
    const int trials = 20000;
    for (int i = 0; i < trials; ++i) {
        const std::array<double, 3> repeats{random.normal(4, 0.01), random.normal(4, 0.01),
                                            random.normal(4, 0.01)};
        const auto length = lengthStatistic(repeats, {}, {});
        const double error = std::abs(length->mean_m - 4);
        covered += error <= *length->expandedUncertainty_m ? 1 : 0;
        coveredByTwo += error <= 2 * *length->standardUncertainty_m ? 1 : 0;
    }
    EXPECT_NEAR(covered / static_cast<double>(trials), 0.95, 0.006);
    EXPECT_NEAR(coveredByTwo / static_cast<double>(trials), 0.816, 0.01);
}

TEST(Length, SensorNoiseAndSpacingAddInSquares) {
    EXPECT_NEAR((EndUncertainty{0.03, 0.12}).standard_m(), std::sqrt(0.0009 + 0.0012), 1e-15);
    EXPECT_NEAR(tapeUncertainty(0.01), 0.01 / std::sqrt(12.0), 1e-15);
}

TEST(Length, RegistrationShareFollowsThePoseNumerically) {
    // Against the spread of a point under poses drawn from the covariance.
    Eigen::Matrix<double, 6, 6> root = Eigen::Matrix<double, 6, 6>::Zero();
    root.diagonal() << 0.01, 0.02, 0.005, 0.001, 0.002, 0.003;
    root(0, 4) = 0.004;
    const Eigen::Matrix<double, 6, 6> covariance = root * root.transpose();
    const Eigen::Vector3d lever(3, -2, 1);
    const Eigen::Vector3d direction(1, 2, -1);
    Random random(3);
    double squares = 0;
    const int trials = 20000;
    for (int i = 0; i < trials; ++i) {
        Eigen::Matrix<double, 6, 1> unit;
        for (int k = 0; k < 6; ++k) unit[k] = random.normal();
        const Eigen::Matrix<double, 6, 1> step = root * unit;
        const Eigen::Vector3d w = step.tail<3>();
        const Eigen::Vector3d moved =
            Eigen::AngleAxisd(w.norm(), w.normalized()) * lever + step.head<3>() - lever;
        squares += std::pow(moved.dot(direction.normalized()), 2);
    }
    const double share = registrationShare(covariance, lever, direction);
    EXPECT_NEAR(share, std::sqrt(squares / trials), 0.02 * share);
}

TEST(Length, RelativeErrorIsSignedAndNeedsATape) {
    EXPECT_DOUBLE_EQ(*relativeError(4.83, 4.88), (4.83 - 4.88) / 4.88);
    EXPECT_LT(*relativeError(4.83, 4.88), 0);
    EXPECT_FALSE(relativeError(1, 0));
}
