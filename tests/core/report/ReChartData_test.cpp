#include "core/report/ReChartData.h"

#include <gtest/gtest.h>
#include "tests/core/report/MeasuredExample.h"

namespace vestige {
namespace {

TEST(ReChartData, GroupsSignedPercentByObject) {
    const MeasuredScene scene = test::measuredExample();
    const BarChart chart = relativeErrorChart(scene.accuracy);
    ASSERT_EQ(chart.categories.size(), 7u);
    ASSERT_EQ(chart.series.size(), 2u);
    EXPECT_EQ(chart.unit, "%");
    EXPECT_NEAR(chart.series[0].values[0].value(), -1, 1e-9);
    EXPECT_NEAR(chart.series[0].values[3].value(), 20, 1e-9);
    EXPECT_TRUE(chart.series[0].excluded[3]);
    EXPECT_FALSE(chart.series[0].excluded[0]);
    EXPECT_FALSE(chart.series[1].values[1]) << "not measurable";
}

TEST(ReChartData, KeepsObjectsThatOnlyOneMethodNames) {
    const AccuracyObject one{"Mirror", 0.2, 0.21, {}, false};
    const AccuracyObject other{"Handle", 0.2, 0.19, {}, false};
    const std::vector<MethodAccuracy> methods{methodAccuracy("a", {&one, 1}),
                                              methodAccuracy("b", {&other, 1})};
    const BarChart chart = relativeErrorChart(methods);
    EXPECT_EQ(chart.categories, (std::vector<std::string>{"Mirror", "Handle"}));
    EXPECT_FALSE(chart.series[0].values[1]);
    EXPECT_NEAR(chart.series[1].values[1].value(), -5, 1e-9);
}

TEST(ReChartData, SplitsManyObjectsEvenly) {
    const MeasuredScene scene = test::measuredExample();
    const auto charts = relativeErrorCharts(scene.accuracy, 4);
    ASSERT_EQ(charts.size(), 2u);
    EXPECT_EQ(charts[0].categories.size(), 3u);
    EXPECT_EQ(charts[1].categories.size(), 4u);
    EXPECT_NEAR(charts[1].series[0].values[0].value(), 20, 1e-9);
    EXPECT_TRUE(charts[1].series[0].excluded[0]);
    EXPECT_TRUE(relativeErrorCharts({}).empty());
}

}  // namespace
}  // namespace vestige
