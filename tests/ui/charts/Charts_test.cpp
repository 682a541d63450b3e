#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>

#include "ui/charts/FitChart.h"
#include "ui/charts/Histogram.h"
#include "ui/charts/ReChart.h"

namespace vestige {
namespace {

constexpr QRectF kArea(20, 10, 360, 240);

FitChart sample() {
    FitChart chart;
    for (int i = 0; i < 6; ++i)
        chart.points.push_back({-100.0 - 10 * i, i < 3 ? 2.0 : 1.0, 0.5, i % 3 == 0 ? 0 : 0.1 / i, i != 4});
    chart.levels = {0, 3};
    return chart;
}

ChartStyle inkStyle() {
    QFont font;
    font.setPixelSize(10);
    ChartStyle style = paperChartStyle(font, 1);
    style.text = style.muted = style.grid = Qt::black;
    return style;
}

QImage painted(const std::function<void(QPainter&)>& paint) {
    QImage picture(400, 260, QImage::Format_RGB32);
    picture.fill(Qt::white);
    QPainter painter(&picture);
    paint(painter);
    return picture;
}

int inkIn(const QImage& picture, const QRect& place) {
    int ink = 0;
    for (int y = place.top(); y <= place.bottom(); ++y)
        for (int x = place.left(); x <= place.right(); ++x)
            ink += picture.rect().contains(x, y) && picture.pixelColor(x, y) != QColor(Qt::white);
    return ink;
}

}  // namespace

TEST(FitChart, PaintsNothingOutsideItsArea) {
    FitChart chart = sample();
    chart.cursor = 5;
    const QImage picture =
        painted([&](QPainter& painter) { paintFitChart(painter, kArea, chart, inkStyle()); });
    const QRect area = kArea.toRect();
    EXPECT_GT(inkIn(picture, area), 500);
    EXPECT_EQ(inkIn(picture, picture.rect()), inkIn(picture, area));
}

TEST(FitChart, TheCursorStandsWhereAClickFindsItsIteration) {
    FitChart chart = sample();
    const ChartStyle style = inkStyle();
    const QImage without = painted([&](QPainter& painter) { paintFitChart(painter, kArea, chart, style); });
    for (std::size_t wanted = 1; wanted < chart.points.size(); ++wanted) {
        chart.cursor = wanted;
        const QImage with = painted([&](QPainter& painter) { paintFitChart(painter, kArea, chart, style); });
        // The column where most pixels differ is the cursor's line.
        int best = 0;
        int most = 0;
        for (int x = 0; x < with.width(); ++x) {
            int differ = 0;
            for (int y = 0; y < with.height(); ++y) differ += with.pixel(x, y) != without.pixel(x, y);
            if (differ > most) {
                most = differ;
                best = x;
            }
        }
        EXPECT_GT(most, 60);
        EXPECT_EQ(iterationAt(kArea, chart, style, QPointF(best + 0.5, 100)), wanted);
    }
}

TEST(FitChart, AnEmptyTraceHasNoIterations) {
    EXPECT_FALSE(iterationAt(kArea, {}, inkStyle(), {100, 100}));
    const QImage picture = painted([](QPainter& painter) { paintFitChart(painter, kArea, {}, inkStyle()); });
    EXPECT_EQ(inkIn(picture, picture.rect()), 0);
}

TEST(Histogram, BarsStandByTheirCountsAndInsideTheArea) {
    ChartStyle style = inkStyle();
    style.series = {Qt::red};
    const Histogram histogram{{10, 20, 40, 20, 10}, 1.0, "mm", 0};
    const QImage picture =
        painted([&](QPainter& painter) { paintHistogram(painter, kArea, histogram, style); });
    EXPECT_EQ(inkIn(picture, picture.rect()), inkIn(picture, kArea.toRect()));
    const auto redIn = [&](int x) {
        int red = 0;
        for (int y = 0; y < picture.height(); ++y) red += picture.pixelColor(x, y) == QColor(Qt::red);
        return red;
    };
    const double left = kArea.left() + 0.15 * kArea.width();
    const double middle = kArea.center().x() + 8;
    const double right = kArea.right() - 0.15 * kArea.width();
    EXPECT_NEAR(redIn(static_cast<int>(left)), 0.25 * redIn(static_cast<int>(middle)), 2);
    EXPECT_NEAR(redIn(static_cast<int>(left)), redIn(static_cast<int>(right)), 1);
    EXPECT_GT(redIn(static_cast<int>(middle)), 100);
}

TEST(ReChart, AnExcludedValueDoesNotFlattenTheOthers) {
    BarChart chart;
    chart.unit = "%";
    chart.categories = {"a", "b"};
    chart.series = {{"lidar", {2.0, 200.0}, {false, true}}};
    const ChartStyle style = inkStyle();
    const auto ink = [&] {
        const QImage picture =
            painted([&](QPainter& painter) { paintReChart(painter, kArea, chart, style); });
        EXPECT_EQ(inkIn(picture, picture.rect()), inkIn(picture, kArea.toRect())) << "all of it in its area";
        return inkIn(picture, QRect(60, 60, 120, 140));
    };
    const int cut = ink();
    chart.series[0].excluded = {false, false};
    EXPECT_GT(cut, 3 * ink()) << "beside a value that counts the other one is small";
}

TEST(ReChart, ItsLegendWraps) {
    BarChart chart;
    chart.categories = {"a"};
    chart.series = {{"a method with a long name", {1.0}, {}},
                    {"another with a longer one", {1.0}, {}},
                    {"a third", {1.0}, {}}};
    const ChartStyle style = inkStyle();
    const auto secondLine = [&](const QRectF& area) {
        const QImage picture = painted([&](QPainter& painter) { paintReChart(painter, area, chart, style); });
        EXPECT_EQ(inkIn(picture, picture.rect()), inkIn(picture, area.toRect()));
        return inkIn(picture, QRect(static_cast<int>(area.left()) + 40, static_cast<int>(area.top()) + 14,
                                    static_cast<int>(area.width()) - 40, 11));
    };
    EXPECT_GT(secondLine(QRectF(20, 10, 230, 240)), secondLine(QRectF(20, 10, 360, 240)) + 20);
}

}  // namespace vestige
