#include <cmath>

#include "tests/core/measurement/kinds/KindExamples.h"

using namespace vestige;
using namespace vestige::test;
using Kind = MeasurementKind;

namespace {

/// A front 1.8 m wide along a direction, crushed to the depths at even stations, all at one height.
std::vector<Eigen::Vector3d> front(const std::vector<double>& depths, double turn_rad, double mirrored = 1) {
    const Eigen::Vector3d along(std::cos(turn_rad), std::sin(turn_rad), 0);
    const Eigen::Vector3d inward = mirrored * Eigen::Vector3d(-std::sin(turn_rad), std::cos(turn_rad), 0);
    const Eigen::Vector3d origin(500'000, 4'000'000, 0.55);
    std::vector<Eigen::Vector3d> points{origin, origin + 1.8 * along};
    for (std::size_t i = 0; i < depths.size(); ++i)
        points.emplace_back(origin +
                            1.8 * static_cast<double>(i) / static_cast<double>(depths.size() - 1) * along +
                            depths[i] * inward);
    return points;
}

}  // namespace

TEST(Crush, SixStationsComeBackWhicheverSide) {
    const std::vector<double> depths{0.05, 0.12, 0.31, 0.44, 0.38, 0.2};
    for (const double mirrored : {1.0, -1.0}) {
        const auto values = valuesOf(Kind::crush, front(depths, 0.6, mirrored));
        for (std::size_t i = 0; i < 6; ++i)
            EXPECT_NEAR(valueOf(values, "c" + std::to_string(i + 1)), depths[i], 1e-7);
        // The mean that crush-energy programs take: (C1/2 + C2 + C3 + C4 + C5 + C6/2) / 5.
        EXPECT_NEAR(valueOf(values, "crush_mean"), (0.025 + 0.12 + 0.31 + 0.44 + 0.38 + 0.1) / 5, 1e-7);
        EXPECT_NEAR(valueOf(values, "damage_width"), 1.8, 1e-7);
        EXPECT_NEAR(valueOf(values, "damage_offset"), 0, 1e-7);
        EXPECT_NEAR(valueOf(values, "crush_max"), 0.44, 1e-7);
        EXPECT_NEAR(valueOf(values, "level"), 0.55, 1e-9);
        EXPECT_NEAR(valueOf(values, "level_spread"), 0, 1e-9);
        ASSERT_EQ(values.series.size(), 2U);
        EXPECT_NEAR(values.series[1].points[3].second, -0.44, 1e-7);
    }
}

TEST(Crush, MorePicksAreResampledAtEvenStations) {
    // A straight ramp from 0 to 0.5 picked at uneven places.
    std::vector<Eigen::Vector3d> points{{0, 0, 0.5}, {2, 0, 0.5}};
    for (const double x : {0.5, 0.62, 0.9, 1.3, 1.44, 1.9, 2.0}) points.emplace_back(x, (x - 0.5) / 3, 0.5);
    const auto values = valuesOf(Kind::crush, points);
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(valueOf(values, "c" + std::to_string(i + 1)), 0.1 * i, 1e-12);
    EXPECT_NEAR(valueOf(values, "damage_offset"), 0.25, 1e-12);
    // A triangle of depth 0.5: its centroid lies at a third.
    EXPECT_NEAR(valueOf(values, "damage_area"), 0.5 * 1.5 * 0.5, 1e-12);
    EXPECT_NEAR(valueOf(values, "damage_centroid"), 0.5 / 3, 1e-12);
    EXPECT_EQ(valuesOf(Kind::crush, points, {{"stations", 4}}).quantities.size(),
              values.quantities.size() - 2);
}

TEST(Crush, UndamagedOutlineIsTakenFromTheOtherSide) {
    // A car 1.8 m wide whose doors bulge by 0.08 m in the middle; its left side is pushed in flat to 0.3 m.
    const auto bulge = [](double x) { return 0.08 * (1 - std::pow(x / 2 - 1, 2)); };
    for (const double side : {1.0, -1.0}) {
        std::vector<Eigen::Vector3d> points{{0, 0, 0.6}, {4, 0, 0.6}};
        for (int i = 0; i <= 5; ++i) points.emplace_back(0.8 * i, side * (i == 0 || i == 5 ? 0 : 0.3), 0.6);
        for (int i = 0; i <= 40; ++i) points.emplace_back(0.1 * i, side * (1.8 + bulge(0.1 * i)), 0.6);
        const auto values = valuesOf(Kind::crush, points, {{"outline_points", 41}});
        EXPECT_NEAR(valueOf(values, "c1"), 0, 1e-12);
        EXPECT_NEAR(valueOf(values, "c3"), 0.3 + bulge(1.6), 1e-12);
        EXPECT_NEAR(valueOf(values, "c5"), 0.3 + bulge(3.2), 1e-12);
    }
}

TEST(Crush, SaysWhatIsMissing) {
    EXPECT_EQ(whyNot(Kind::crush, {{0, 0, 0}, {0, 0, 0}, {0, 1, 0}, {1, 1, 0}}),
              "the undamaged ends are one and the same");
    EXPECT_EQ(whyNot(Kind::crush, {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 2, 0}}),
              "the points of the damage lie over one place");
    EXPECT_EQ(whyNot(Kind::crush, {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}}),
              "the damage has fewer than two points");
}
