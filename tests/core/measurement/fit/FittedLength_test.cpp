#include "core/measurement/fit/FittedLength.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/measurement/fit/ExtremeFit.h"
#include "tests/core/measurement/fit/FitClouds.h"

namespace vestige {
namespace {

using Vec = Eigen::Vector3d;

FittedEnd end(SnapMode mode, const Vec& position, const Vec& axis, const Vec& variances) {
    FittedEnd made{position, {}};
    made.feature.mode = mode;
    made.feature.position = position;
    made.feature.axis = axis;
    made.feature.covariance = variances.asDiagonal();
    return made;
}

TEST(FittedLength, EdgesAreMeasuredAtRightAngles) {
    const auto a = end(SnapMode::edge, {0, 0, 0}, {0, 1, 0}, {4e-6, 1, 4e-6});
    const auto b = end(SnapMode::edge, {0.5, 0.3, 0}, {0, -1, 0}, {5e-6, 1, 4e-6});
    const FittedLength length = fittedLength(a, b);
    EXPECT_NEAR(length.length_m, 0.5, 1e-12);
    EXPECT_NEAR(length.variance_m2, 9e-6, 1e-12);  // what lies along the edges does not count
}

TEST(FittedLength, OppositePlanesAlongTheirNormalWhenItIsKnown) {
    auto a = end(SnapMode::plane, {0, 0, 0}, {-1, 0, 0}, {1e-6, 0, 0});
    auto b = end(SnapMode::plane, {1.8, 0.3, 0}, {1, 0, 0}, {1e-6, 0, 0});
    a.feature.axisUncertainty = b.feature.axisUncertainty = 0.001;
    EXPECT_NEAR(fittedLength(a, b).length_m, 1.8, 1e-12);
    a.feature.axisUncertainty = b.feature.axisUncertainty = 0.3;
    EXPECT_NEAR(fittedLength(a, b).length_m, std::hypot(1.8, 0.3), 1e-12);
}

TEST(FittedLength, TwoPlacesOnOnePlaneAreAsFarApartAsTheyAre) {
    const auto a = end(SnapMode::plane, {0, 0, 0}, {0, 0, 1}, {1e-6, 1e-6, 1e-6});
    const auto b = end(SnapMode::plane, {0.6, 0.2, 0.001}, {0, 0, 1}, {1e-6, 1e-6, 1e-6});
    EXPECT_NEAR(fittedLength(a, b).length_m, Vec(0.6, 0.2, 0.001).norm(), 1e-12);
}

TEST(FittedLength, TwoPicksOnOneCircleGiveItsDiameter) {
    auto a = end(SnapMode::circle, {0, 0, 0}, {0, 0, 1}, {1e-6, 1e-6, 1e-6});
    auto b = a;
    a.feature.radius = 0.32;
    b.feature.radius = 0.33;
    a.feature.radiusUncertainty = b.feature.radiusUncertainty = 0.002;
    a.pick = {-0.3, 0, 0};
    b.pick = {0.3, 0, 0};
    const FittedLength length = fittedLength(a, b);
    EXPECT_NEAR(length.length_m, 0.65, 1e-12);
    EXPECT_NEAR(length.variance_m2, 0.004 * 0.004, 1e-12);
}

TEST(FittedLength, TwoWheelsFromTheSidesThatWerePicked) {
    auto a = end(SnapMode::circle, {0, 0, 0}, {0, 0, 1}, {0, 0, 0});
    auto b = end(SnapMode::circle, {1, 0, 0}, {0, 0, 1}, {0, 0, 0});
    a.feature.radius = b.feature.radius = 0.28;
    a.pick = {-0.28, 0.02, 0};
    b.pick = {1.28, -0.02, 0};
    EXPECT_NEAR(fittedLength(a, b).length_m, 1.56, 1e-12);
    b.pick = {0.72, 0, 0};  // the near side of the other wheel
    EXPECT_NEAR(fittedLength(a, b).length_m, 1.0, 1e-12);
}

TEST(UpperEnd, IsUnbiasedForFlatTopsAndUprightSurfaces) {
    Random random(5, 1);
    for (const double thickness : {0.0, 0.3}) {
        double sum = 0;
        constexpr int kTrials = 40;
        for (int trial = 0; trial < kTrials; ++trial) {
            std::vector<double> values;
            for (int i = 0; i < 300; ++i)
                values.push_back(1 - thickness * random.uniform() + random.normal(0, 0.03));
            for (int i = 0; i < 2; ++i) values.push_back(1.3 + 0.1 * random.uniform());  // strays
            const auto end = upperEnd(values, 0.03);
            ASSERT_TRUE(end);
            sum += end->place - 1;
        }
        EXPECT_NEAR(sum / kTrials, 0, 0.008) << thickness;
    }
    EXPECT_FALSE(upperEnd({1, 2, 3}, 0.03));
}

}  // namespace
}  // namespace vestige
