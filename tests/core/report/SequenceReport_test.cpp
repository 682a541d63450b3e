#include "core/report/SequenceReport.h"

#include <gmock/gmock.h>

#include "core/base/Csv.h"
#include "core/base/Numbers.h"
#include "core/report/PublishedTables.h"
#include "core/report/SequenceCharts.h"
#include "tests/core/report/ReportText.h"
#include "tests/support/TestPaths.h"

namespace vestige {
namespace {

using testing::HasSubstr;

SequenceScore score(const std::string& method, const std::string& filter, std::optional<double> voxel,
                    double rpe) {
    SequenceScore made;
    made.method = method;
    made.filter = filter;
    made.voxel_m = voxel;
    made.error.pairs = 31;
    made.error.translation_m = rpe;
    made.error.rotation_rad = rpe / 10;
    made.seconds = 100 * rpe;
    return made;
}

/// Both tables, with a tenth of the published errors.
std::vector<SequenceScore> tenths() {
    std::vector<SequenceScore> scores;
    for (const int table : {2, 3})
        for (const PublishedRow& row : publishedTable(table))
            scores.push_back(
                score(std::string(row.method), std::string(row.filter), row.voxel_m, row.rpe_m / 10));
    return scores;
}

TEST(PublishedTables, AreThoseOfTheOracles) {
    const auto named = [](const std::string& method) {
        return method == "classic NDT" ? "ndt" : "improved-ndt";
    };
    const auto two = readCsv(test::dataFile("oracles/table2.csv"));
    ASSERT_TRUE(two);
    ASSERT_EQ(two->size(), 1 + publishedTable(2).size());
    for (std::size_t i = 1; i < two->size(); ++i) {
        const auto& cells = two->at(i).cells;
        const auto row = publishedRow(2, named(cells[0]), "none", *parseReal(cells[1]));
        ASSERT_TRUE(row) << i;
        EXPECT_EQ(row->seconds, *parseReal(cells[2]));
        EXPECT_EQ(row->rpe_m, *parseReal(cells[3]));
    }
    const auto three = readCsv(test::dataFile("oracles/table3.csv"));
    ASSERT_TRUE(three);
    ASSERT_EQ(three->size(), 1 + publishedTable(3).size());
    for (std::size_t i = 1; i < three->size(); ++i) {
        const auto& cells = three->at(i).cells;
        const auto row = publishedRow(3, named(cells[2]), cells[1], *parseReal(cells[0]));
        ASSERT_TRUE(row) << i;
        EXPECT_EQ(row->seconds, *parseReal(cells[3]));
        EXPECT_EQ(row->rpe_m, *parseReal(cells[4]));
    }
    EXPECT_TRUE(publishedTable(4).empty());
    EXPECT_FALSE(publishedRow(2, "icp", "none", 1));
}

TEST(SequenceReport, ShowsBothTablesBesideThePublishedFigures) {
    SequenceReportInput input{
        "pavilion", {32, 1000000, 18, 0.6, 0.1}, tenths(), {2, 3}, "2026-11-22", 2, "", "0.1 m", "default"};
    const std::string text = test::textOf(sequenceReport(input));
    EXPECT_THAT(text, HasSubstr("Radius of the filters: 0.1 m"));
    EXPECT_THAT(text, HasSubstr("# Table 2: classic and improved NDT"));
    EXPECT_THAT(text, HasSubstr("# Table 3: filters before improved NDT"));
    EXPECT_THAT(text, HasSubstr("\n0.0670\t\n0.67\t\n0.0620\t\n0.62\t"));
    EXPECT_THAT(text, HasSubstr("\n0.0320\t\n0.32\t\n0.0360\t\n0.36\t\n0.0350\t\n0.35\t"));
    EXPECT_THAT(text, HasSubstr("lower relative pose error at 5 of 6 sizes"));
    EXPECT_THAT(text, HasSubstr("at 0.8 m, it is 1.7 % higher"));
    EXPECT_THAT(text, HasSubstr("at 0.1 m gaussian (32.0 mm, unfiltered 36.0 mm)"));
    EXPECT_THAT(text, HasSubstr("improved NDT, median, published"));
    // Means over the sizes: 0.548 and 0.502 as published, a tenth of them here.
    EXPECT_THAT(text, HasSubstr("\nmean\t\n0.0548\t\n0.55\t\n0.0502\t\n0.50\t"));
}

TEST(SequenceReport, SaysNothingOfTablesThatWereNotRun) {
    SequenceReportInput input{"pavilion",
                              {3, 30, 1, 0.6, 0.1},
                              {score("icp", "none", {}, 0.5)},
                              {},
                              "2026-11-22",
                              2,
                              "A processor",
                              "0.1 m",
                              ""};
    const std::string text = test::textOf(sequenceReport(input));
    EXPECT_THAT(text, testing::Not(HasSubstr("Table 2")));
    EXPECT_THAT(text, HasSubstr("chosen"));
    EXPECT_THAT(text, HasSubstr("Processor: A processor"));
    EXPECT_THAT(text, testing::Not(HasSubstr("Radius"))) << "no filter was used";
    EXPECT_EQ(conclusionOf(2, input.scores), "");
    EXPECT_EQ(conclusionOf(3, input.scores), "");
    // A part of a table leaves dashes, no means and no verdict on filters.
    input.scores = {score("improved-ndt", "gaussian", 0.2, 0.1)};
    input.tables = {3};
    EXPECT_THAT(test::textOf(sequenceReport(input)), HasSubstr("\n0.1000\t\n0.34\t\n–\t"));
    EXPECT_EQ(conclusionOf(3, input.scores), "");
}

TEST(SequenceCharts, HaveALinePerMethodAndFilter) {
    std::vector<SequenceScore> scores = tenths();
    scores.push_back(score("icp", "none", {}, 0.3));
    const auto charts = sequenceCharts(scores);
    ASSERT_EQ(charts.size(), 3U);
    ASSERT_EQ(charts[0].series.size(), 5U);
    EXPECT_EQ(charts[0].series[1].name, "improved NDT");
    EXPECT_EQ(charts[0].series[1].points.size(), 6U);
    EXPECT_EQ(charts[0].series[1].points[0], std::pair(1.0, 0.62 / 10));
    const auto beside = sequenceCharts(scores, 2);
    EXPECT_EQ(beside[0].series.size(), 7U);
    EXPECT_TRUE(beside[0].series.back().dashed);
    EXPECT_EQ(beside[1].series.size(), 5U) << "no rotation was published";
    EXPECT_TRUE(sequenceCharts({}).empty());
}

}  // namespace
}  // namespace vestige
