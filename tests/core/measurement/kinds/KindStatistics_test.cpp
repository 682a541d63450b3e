#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/base/Random.h"
#include "core/measurement/Length.h"
#include "tests/core/measurement/kinds/KindExamples.h"

using namespace vestige;
using namespace vestige::test;
using Kind = MeasurementKind;

namespace {

Eigen::Vector3d normal3(Random& random, double sigma) {
    const double x = random.normal(0, sigma), y = random.normal(0, sigma), z = random.normal(0, sigma);
    return {x, y, z};
}

/// How often the 95 % interval of a figure holds the true one, where the sensor moves every feature by
/// `noise` once and for all, and every repeat is picked anew within `pick` of it.
double coverage(Kind kind, const std::vector<Eigen::Vector3d>& truth, const std::string& key, double noise,
                double pick, const std::map<std::string, double>& settings = {}, int runs = 800) {
    const double exact = valueOf(valuesOf(kind, truth, settings), key);
    int held = 0;
    for (int run = 0; run < runs; ++run) {
        Random random(42, static_cast<std::uint64_t>(run));
        std::vector<Eigen::Vector3d> seen = truth;
        for (auto& point : seen) point += normal3(random, noise);
        KindMeasurement measurement{kind, settings, {}, {{"scan", {}}}};
        for (int repeat = 0; repeat < 3; ++repeat) {
            KindRepeat each;
            for (const auto& point : seen) each.ends.push_back({point + normal3(random, pick), noise, 0});
            measurement.repeats.push_back(std::move(each));
        }
        const KindOutcome outcome = kindStatistics(measurement);
        const QuantityStatistic found = statisticOf(outcome, key);
        held += *found.low <= exact && exact <= *found.high;
    }
    return static_cast<double>(held) / runs;
}

std::vector<Eigen::Vector3d> arcOf(double radius, double half_rad, int count) {
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < count; ++i) {
        const double angle = half_rad * (2.0 * i / (count - 1) - 1);
        points.emplace_back(radius * std::sin(angle), radius * std::cos(angle), 0);
    }
    return points;
}

}  // namespace

TEST(Budget, AddsSquaresAndDegreesOfFreedom) {
    // GUM G.4.1: u^2 = 9 + 16, nu = 25^2 / (9^2 / 2 + 16^2 / 8).
    const Budget budget = combined({{"repeats", 3, "m", 1, Distribution::student, 2, 0},
                                    {"noise", 2, "m", -2, Distribution::normal, 8, 0},
                                    {"nothing", 0, "m", 5, Distribution::normal, 1, 0}});
    EXPECT_NEAR(budget.standard, 5, 1e-12);
    EXPECT_NEAR(budget.degreesOfFreedom, 625 / (81 / 2.0 + 256 / 8.0), 1e-12);
    EXPECT_NEAR(budget.expanded, 5 * studentQuantile975(budget.degreesOfFreedom), 1e-12);
    EXPECT_NEAR(budget.contributions[0].share, 0.36, 1e-12);
    EXPECT_NEAR(budget.contributions[1].share, 0.64, 1e-12);
    EXPECT_EQ(budget.contributions[2].share, 0);
}

TEST(KindStatistics, DistanceAgreesWithTheLengthStatistic) {
    const std::vector<double> lengths{1.02, 0.98, 1.01};
    KindMeasurement measurement{Kind::distance, {}, {}, {{"aerial", {}}}};
    for (const double length : lengths)
        measurement.repeats.push_back(
            {{{{5, 5, 5}, 0.03, 0.05},
              {Eigen::Vector3d(5, 5, 5) + length * Eigen::Vector3d(2, 1, 2) / 3, 0.01, 0.02}}});
    const auto& found = statisticOf(kindStatistics(measurement), "distance");
    const auto expected = lengthStatistic(lengths, {0.03, 0.05}, {0.01, 0.02});
    EXPECT_NEAR(found.mean, expected->mean_m, 1e-12);
    EXPECT_NEAR(*found.repeatSd, *expected->repeatSd_m, 1e-12);
    EXPECT_NEAR(*found.standardUncertainty, *expected->standardUncertainty_m, 1e-5);
    EXPECT_NEAR(*found.expandedUncertainty, *expected->expandedUncertainty_m, 1e-4);
    double shares = 0;
    for (const auto& each : found.budget.contributions) shares += each.share;
    EXPECT_NEAR(shares, 1, 1e-12);
    ASSERT_EQ(found.budget.contributions.size(), 3U);
    EXPECT_EQ(found.budget.contributions[0].source, "repeats");
    EXPECT_EQ(found.budget.contributions[0].degreesOfFreedom, 2);
    EXPECT_EQ(found.budget.contributions[2].distribution, Distribution::rectangular);
}

TEST(KindStatistics, OneRepeatHasABudgetButNoInterval) {
    const KindOutcome outcome =
        kindStatistics({Kind::distance, {}, {{{{{0, 0, 0}, 0.03, 0}, {{1, 0, 0}, 0.03, 0}}}}, {{"a", {}}}});
    const auto& found = statisticOf(outcome, "distance");
    EXPECT_FALSE(found.expandedUncertainty);
    EXPECT_NEAR(found.budget.standard, 0.03 * std::sqrt(2), 1e-6);
}

TEST(KindStatistics, ARepeatThatMeansNothingIsToldAndLeftOut) {
    const KindOutcome outcome = kindStatistics(
        {Kind::arc,
         {},
         {{endsAt({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}})}, {endsAt({{0, 0, 0}, {1, 1, 0}, {2, 0, 0}})}},
         {{"a", {}}}});
    EXPECT_EQ(statisticOf(outcome, "radius_fit").repeats.size(), 1U);
    ASSERT_EQ(outcome.notes.size(), 1U);
    EXPECT_TRUE(outcome.notes[0].starts_with("repeat 1: ")) << outcome.notes[0];
}

TEST(KindStatistics, RegistrationMovesAllPicksOfAScanTogether) {
    // A turn of 1 mrad (1 SD) about the upright axis through the pivot.
    PoseUncertainty pose;
    pose.covariance(5, 5) = 1e-6;
    const auto measured = [&](std::size_t bodyOfSecond, Kind kind) {
        KindRepeat repeat{{{{10, 0, 0}, 0, 0, {}, {}, 0}, {{10, 4, 0}, 0, 0, {}, {}, bodyOfSecond}}};
        return kindStatistics({kind, {}, {repeat, repeat}, {{"target", {}}, {"front", pose}}});
    };
    const auto apart = measured(1, Kind::distance);
    const auto& across = statisticOf(apart, "distance");
    // The second end, 10 m from the pivot, moves by 10 mm along the length.
    EXPECT_NEAR(*across.standardUncertainty, 0.01, 1e-6);
    EXPECT_EQ(across.budget.contributions.back().source, "registration of front");
    EXPECT_NEAR(across.budget.contributions.back().share, 1, 1e-9);
    KindRepeat together{{{{10, 0, 0}, 0, 0, {}, {}, 1}, {{10, 4, 3}, 0, 0, {}, {}, 1}}};
    const KindOutcome within =
        kindStatistics({Kind::distance, {}, {together, together}, {{"target", {}}, {"front", pose}}});
    EXPECT_EQ(*statisticOf(within, "distance").standardUncertainty, 0);
    // A tilt of the scan changes the upright part of a way within it.
    PoseUncertainty tilt;
    tilt.covariance(0 + 3, 0 + 3) = 1e-6;
    const KindOutcome upright =
        kindStatistics({Kind::vertical, {}, {together, together}, {{"target", {}}, {"front", tilt}}});
    EXPECT_NEAR(*statisticOf(upright, "vertical").standardUncertainty, 0.004, 1e-6);
}

TEST(KindStatistics, FittedFeaturesBringTheirOwnCovariance) {
    Eigen::Matrix3d covariance = Eigen::Vector3d(1e-6, 4e-6, 9e-6).asDiagonal();
    KindEnd a{{0, 0, 0}, 0.03, 0.1, covariance}, b{{0, 2, 0}, 0.03, 0.1, covariance};
    const KindOutcome outcome = kindStatistics({Kind::distance, {}, {{{a, b}}, {{a, b}}}, {{"a", {}}}});
    EXPECT_NEAR(*statisticOf(outcome, "distance").standardUncertainty, std::sqrt(8e-6), 1e-9);
}

TEST(KindCoverage, OfRepeatedPicksIsAsStated) {
    EXPECT_NEAR(
        coverage(Kind::polyline, {{0, 0, 0}, {5, 1, 0}, {9, 3, 0.2}, {14, 3, 0.1}}, "length", 0.02, 0.02),
        0.95, 0.02);
    EXPECT_NEAR(coverage(Kind::angle, {{2, 0, 0}, {0, 0, 0}, {1, 2, 0.5}}, "angle", 0.01, 0.01), 0.95, 0.02);
    EXPECT_NEAR(coverage(Kind::area, {{0, 0, 0}, {4, 0, 0}, {4, 3, 0.1}, {0, 3, 0}}, "area_plan", 0.02, 0.01),
                0.95, 0.02);
    EXPECT_NEAR(coverage(Kind::pointToPlane, {{1, 1, 2}, {0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {3, 3, 0}},
                         "distance", 0.02, 0.01),
                0.95, 0.02);
    EXPECT_NEAR(coverage(Kind::crush,
                         {{0, 0, 0.5},
                          {1.8, 0, 0.5},
                          {0, 0.1, 0.5},
                          {0.36, 0.2, 0.5},
                          {0.72, 0.3, 0.5},
                          {1.08, 0.4, 0.5},
                          {1.44, 0.4, 0.5},
                          {1.8, 0.3, 0.5}},
                         "crush_mean", 0.01, 0.005),
                0.95, 0.02);
}

TEST(KindCoverage, OfRadiusAndSpeedHoldsForFlatArcs) {
    // Middle ordinate 0.5 m; the noise is 4 to 8 % of it, where a symmetric interval of the radius fails.
    const auto arc = arcOf(64, 0.125, 9);
    for (const double noise : {0.02, 0.04}) {
        EXPECT_NEAR(coverage(Kind::arc, arc, "radius_chord", noise, 0.005, {}, 600), 0.95, 0.025) << noise;
        // Rather too wide: scatter beyond what is expected counts, scatter below does not.
        EXPECT_NEAR(coverage(Kind::arc, arc, "radius_fit", noise, 0.005, {}, 600), 0.96, 0.025) << noise;
    }
    EXPECT_NEAR(coverage(Kind::arc, arc, "speed_fit", 0.02, 0.005,
                         {{"drag_factor", 0.7}, {"drag_factor_range", 0}}, 600),
                0.96, 0.025);
}

TEST(KindCoverage, ASingleTracedArcHasAnIntervalFromItsOwnScatter) {
    const auto truth = arcOf(40, 0.3, 12);
    int held = 0;
    constexpr int kRuns = 1000;
    for (int run = 0; run < kRuns; ++run) {
        Random random(5, static_cast<std::uint64_t>(run));
        std::vector<Eigen::Vector3d> seen = truth;
        for (auto& point : seen) point += normal3(random, 0.03);
        // Nothing is known of the noise beforehand: all comes from the scatter, with n - 3 degrees.
        const KindOutcome outcome = kindStatistics({Kind::arc, {}, {{endsAt(seen)}}, {{"scan", {}}}});
        const auto& radius = statisticOf(outcome, "radius_fit");
        ASSERT_TRUE(radius.expandedUncertainty);
        EXPECT_EQ(*radius.degreesOfFreedom, 9);
        held += *radius.low <= 40 && 40 <= *radius.high;
        EXPECT_FALSE(statisticOf(outcome, "radius_chord").expandedUncertainty);
    }
    EXPECT_NEAR(static_cast<double>(held) / kRuns, 0.95, 0.02);
}

TEST(Arc, PublishedLimitsOfThreePointsAndGainOfFifteen) {
    // Three points stay within 5 % at 95 % only below about sigma / m = 0.018; fifteen points shrink the
    // interval by up to 42 %.
    const auto relative = [](int count, double sigmaOverM) {
        const auto points = arcOf(50, 0.2, count);
        const double m = 50 * (1 - std::cos(0.2));
        const KindRepeat repeat{endsAt(points, sigmaOverM * m)};
        const KindOutcome outcome = kindStatistics({Kind::arc, {}, {repeat, repeat}, {{"scan", {}}}});
        const auto& radius = statisticOf(outcome, "radius_fit");
        return *radius.expandedUncertainty / radius.mean;
    };
    EXPECT_LT(relative(3, 0.018), 0.05);
    EXPECT_GT(relative(3, 0.022), 0.05);
    const double shrunk = 1 - relative(15, 0.018) / relative(3, 0.018);
    EXPECT_GT(shrunk, 0.33);
    EXPECT_LT(shrunk, 0.42);
}
