#include <cmath>
#include <numbers>

#include "core/base/Random.h"
#include "tests/core/measurement/kinds/KindExamples.h"

using namespace vestige;
using namespace vestige::test;
using Kind = MeasurementKind;

namespace {

template <class Height>
std::vector<Eigen::Vector3d> surface(double side, std::size_t count, Height height, double noise = 0) {
    Random random(7);
    std::vector<Eigen::Vector3d> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = random.uniform(-side, side), y = random.uniform(-side, side);
        points.emplace_back(x, y, height(x, y) + random.normal(0, noise));
    }
    return points;
}

}  // namespace

TEST(Profile, HeightsOfARampWithAKerb) {
    const auto cloud = surface(5, 200'000, [](double x, double) { return 0.02 * x + (x > 1 ? 0.12 : 0); });
    const auto values = valuesOf(Kind::profile, {{-4, 0.3, 0}, {4, 0.3, 0}}, {{"samples", 80}}, cloud);
    EXPECT_NEAR(valueOf(values, "length"), 8, 1e-12);
    // The outermost stations lie half a step, 0.05 m, within the ends.
    EXPECT_NEAR(valueOf(values, "rise"), 0.02 * 7.9 + 0.12, 0.002);
    EXPECT_NEAR(valueOf(values, "coverage"), 100, 1e-9);
    // The line between the ends rises by 0.12 m besides the grade; the kerb comes at 4.95 of 7.9 m.
    EXPECT_NEAR(valueOf(values, "highest"), 0.12 * (1 - 5.0 / 7.9), 0.003);
    EXPECT_NEAR(valueOf(values, "deepest"), 0.12 * 4.9 / 7.9, 0.003);
    ASSERT_EQ(values.series.size(), 1U);
    EXPECT_EQ(values.series[0].points.size(), 80U);
    EXPECT_EQ(valuesOf(Kind::profile, {{-4, 0, 0}, {4, 0, 0}}).quantities.size(), 1U)
        << "without a cloud the length is left";
}

TEST(Volume, OfACapAndOfAPit) {
    // A spherical cap of radius 1.25 and height 0.5: pi h^2 (3 r - h) / 3.
    const auto cap = [](double x, double y) {
        const double square = x * x + y * y;
        return square < 1 ? std::sqrt(1.25 * 1.25 - square) - 0.75 : 0.0;
    };
    const double exact = std::numbers::pi * 0.25 * (3.75 - 0.5) / 3;
    const std::vector<Eigen::Vector3d> outline{
        {-1.5, -1.5, 0}, {1.5, -1.5, 0}, {1.5, 1.5, 0}, {-1.5, 1.5, 0}};
    const auto up = valuesOf(Kind::volume, outline, {}, surface(2, 100'000, cap));
    EXPECT_NEAR(valueOf(up, "volume"), exact, 0.01 * exact);
    EXPECT_NEAR(valueOf(up, "area_plan"), 9, 1e-12);
    EXPECT_NEAR(valueOf(up, "coverage"), 100, 1);
    const auto pit = valuesOf(Kind::volume, outline, {{"level_base", 1}},
                              surface(2, 100'000, [&](double x, double y) { return -cap(x, y); }));
    EXPECT_NEAR(valueOf(pit, "volume_below"), exact, 0.01 * exact);
    EXPECT_NEAR(valueOf(pit, "volume_net"), -exact, 0.01 * exact);
    EXPECT_EQ(whyNot(Kind::volume, outline), "no point of the cloud lies within the outline");
}

TEST(Volume, OverASlopeThroughTheCorners) {
    const auto slope = [](double x, double y) { return 0.1 * x - 0.05 * y; };
    const auto at = [&](double x, double y) { return Eigen::Vector3d(x, y, slope(x, y)); };
    const auto values = valuesOf(Kind::volume, {at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)}, {},
                                 surface(
                                     2, 50'000, [&](double x, double y) { return slope(x, y) + 0.3; }, 0.01));
    EXPECT_NEAR(valueOf(values, "volume"), 4 * 0.3, 0.005);
}

TEST(Volume, UncertaintyHoldsTheTruthAboutAsOftenAsItSays) {
    // The corners are off by 20 mm, the cloud by 10 mm; base level through the lowest would be biased, the
    // fitted plane is not.
    const std::vector<Eigen::Vector3d> corners{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    int held = 0;
    constexpr int kRuns = 300;
    for (int run = 0; run < kRuns; ++run) {
        Random random(100 + static_cast<std::uint64_t>(run));
        KindMeasurement measurement{Kind::volume, {{"cell_m", 0.2}}, {}, {{"scan", {}}}};
        // What the sensor did to a corner stays through the repeats; where it is picked differs.
        std::vector<Eigen::Vector3d> seen = corners;
        for (auto& corner : seen)
            corner += Eigen::Vector3d(random.normal(0, 0.02), random.normal(0, 0.02), random.normal(0, 0.02));
        for (int repeat = 0; repeat < 3; ++repeat) {
            KindRepeat each;
            for (const auto& corner : seen)
                each.ends.push_back(
                    {corner + 0.005 * Eigen::Vector3d(random.normal(), random.normal(), random.normal()),
                     0.02, 0});
            for (int i = 0; i < 2000; ++i)
                each.cloud.emplace_back(random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2),
                                        0.5 + random.normal(0, 0.01));
            measurement.repeats.push_back(std::move(each));
        }
        const auto& volume = statisticOf(kindStatistics(measurement), "volume");
        held += std::abs(volume.mean - 4 * 0.5) <= *volume.expandedUncertainty;
    }
    EXPECT_GE(held, 0.91 * kRuns);
    EXPECT_LE(held, 0.995 * kRuns);
}
