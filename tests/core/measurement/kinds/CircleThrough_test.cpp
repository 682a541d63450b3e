#include "core/measurement/kinds/CircleThrough.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/base/Random.h"

using namespace vestige;

namespace {

double squares(const std::vector<Eigen::Vector2d>& points, const Eigen::Vector2d& centre, double radius) {
    double sum = 0;
    for (const auto& point : points) sum += std::pow((point - centre).norm() - radius, 2);
    return sum;
}

}  // namespace

TEST(CircleThrough, ExactPointsOfAnyArc) {
    for (const double span : {0.02, 0.3, 2.0, 6.0}) {
        std::vector<Eigen::Vector2d> points;
        for (int i = 0; i <= 10; ++i)
            points.emplace_back(1000 + 12 * std::cos(span * i / 10), -300 + 12 * std::sin(span * i / 10));
        const auto fit = circleThrough(points);
        ASSERT_TRUE(fit) << span;
        EXPECT_NEAR(fit->radius, 12, 12 * 1e-7 / (span * span)) << span;
        EXPECT_LT(fit->scatter, 1e-9);
        EXPECT_EQ(fit->degreesOfFreedom, 8U);
    }
}

TEST(CircleThrough, IsTheMinimumOfTheSquaredDistances) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        Random random(seed);
        std::vector<Eigen::Vector2d> points;
        for (int i = 0; i < 9; ++i) {
            const double angle = 0.12 * i;
            points.emplace_back(5 * std::cos(angle) + random.normal(0, 0.05),
                                5 * std::sin(angle) + random.normal(0, 0.05));
        }
        const auto fit = circleThrough(points);
        ASSERT_TRUE(fit);
        const double least = squares(points, fit->centre, fit->radius);
        for (const double step : {1e-3, -1e-3})
            for (int way = 0; way < 3; ++way) {
                const Eigen::Vector2d moved =
                    fit->centre +
                    (way < 2 ? Eigen::Vector2d(step * Eigen::Vector2d::Unit(way)) : Eigen::Vector2d(0, 0));
                EXPECT_GE(squares(points, moved, fit->radius + (way == 2 ? step : 0)), least - 1e-12) << seed;
            }
    }
}

TEST(CircleThrough, UncertaintyIsTheSpreadOfFits) {
    double sum = 0, square = 0, stated = 0;
    constexpr int kRuns = 2000;
    for (int run = 0; run < kRuns; ++run) {
        Random random(3, static_cast<std::uint64_t>(run));
        std::vector<Eigen::Vector2d> points;
        for (int i = 0; i < 12; ++i) {
            const double angle = 0.08 * i;
            points.emplace_back(20 * std::cos(angle) + random.normal(0, 0.01),
                                20 * std::sin(angle) + random.normal(0, 0.01));
        }
        const auto fit = circleThrough(points);
        ASSERT_TRUE(fit);
        sum += fit->radius;
        square += fit->radius * fit->radius;
        stated += 0.01 * fit->radiusPerUnit / kRuns;
    }
    const double mean = sum / kRuns;
    EXPECT_NEAR(std::sqrt(square / kRuns - mean * mean) / stated, 1, 0.05);
}

TEST(CircleThrough, SaysWhereThereIsNone) {
    const std::vector<Eigen::Vector2d> line{{0, 0}, {1, 1}, {2, 2}, {3, 3}};
    EXPECT_FALSE(circleThrough(line));
    const std::vector<Eigen::Vector2d> one{{2, 1}, {2, 1}, {2, 1}};
    EXPECT_FALSE(circleThrough(one));
    EXPECT_FALSE(circleThrough(std::span(line).first(2)));
}
