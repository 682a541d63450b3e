#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include "core/base/Csv.h"
#include "core/base/Numbers.h"
#include "core/report/AccuracyCsv.h"
#include "core/report/MeasurementsCsv.h"
#include "core/report/ResultsJson.h"
#include "tests/core/report/MeasuredExample.h"

namespace vestige {
namespace {

TEST(MeasurementsCsv, HasTheContractsColumnsAndExactNumbers) {
    const MeasuredScene scene = test::measuredExample();
    const auto rows = parseCsv(measurementsCsv(scene), "csv").value();
    const std::vector<std::string> head{"object",
                                        "method",
                                        "tape_m",
                                        "measured_1_m",
                                        "measured_2_m",
                                        "measured_3_m",
                                        "measured_mean_m",
                                        "repeat_sd_m",
                                        "expanded_uncertainty_m",
                                        "re",
                                        "excluded",
                                        "kind",
                                        "horizontal_m",
                                        "vertical_m",
                                        "small"};
    ASSERT_EQ(rows.size(), scene.lengths.size() + 1);
    EXPECT_EQ(rows[0].cells, head);
    EXPECT_EQ(rows[3].cells[0], "Width, \"front\"");
    EXPECT_EQ(parseReal(rows[1].cells[6]), scene.lengths[0].length->mean_m);
    EXPECT_EQ(parseReal(rows[1].cells[8]), scene.lengths[0].length->expandedUncertainty_m);
    EXPECT_EQ(parseReal(rows[1].cells[9]), scene.lengths[0].re);
    EXPECT_EQ(rows[7].cells[10], "true");
    EXPECT_EQ(rows[1].cells[10], "false");
}

TEST(MeasurementsCsv, LeavesCellsEmptyWhereNothingWasMeasuredOrRepeated) {
    const auto rows = parseCsv(measurementsCsv(test::measuredExample()), "csv").value();
    const std::vector<std::string> notMeasured{"Width, \"front\"",
                                               "photogrammetry",
                                               "1.84",
                                               "",
                                               "",
                                               "",
                                               "",
                                               "",
                                               "",
                                               "",
                                               "false",
                                               "",
                                               "",
                                               "",
                                               "false"};
    EXPECT_EQ(rows[4].cells, notMeasured);
    EXPECT_FALSE(rows[2].cells[3].empty());
    EXPECT_EQ(rows[2].cells[4], "") << "one repeat";
    EXPECT_EQ(rows[2].cells[7], "") << "so no standard deviation";
    EXPECT_EQ(rows[2].cells[8], "") << "and no uncertainty";
}

TEST(MeasurementsCsv, KeepsEveryRepeat) {
    MeasuredScene scene;
    scene.lengths.push_back(test::measuredRow("Length", "lidar", 2, {2.01, 2.02, 2.03, 2.04, 2.05}));
    const auto rows = parseCsv(measurementsCsv(scene), "csv").value();
    ASSERT_EQ(rows[0].cells.size(), 17u);
    EXPECT_EQ(rows[0].cells[10], "excluded");
    EXPECT_EQ(rows[0].cells[12], "measured_5_m");
    EXPECT_EQ(rows[1].cells[5], "2.03");
    EXPECT_EQ(rows[0].cells[16], "small");
    EXPECT_EQ(rows[1].cells[12], "2.05");
}

TEST(AccuracyCsv, NamesTheExcludedObjects) {
    const MeasuredScene scene = test::measuredExample();
    const auto rows = parseCsv(accuracyCsv(scene.accuracy), "csv").value();
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[0].cells, (std::vector<std::string>{"method", "n", "sd", "rmse", "rmse_all", "rmse_abs_m",
                                                       "excluded", "rmse_large", "small"}));
    EXPECT_EQ(rows[1].cells[0], "lidar");
    EXPECT_EQ(rows[1].cells[1], "7");
    EXPECT_EQ(parseReal(rows[1].cells[3]), scene.accuracy[0].rmse);
    EXPECT_EQ(rows[1].cells[6], "Box");
    EXPECT_EQ(rows[2].cells[1], "6");
    EXPECT_EQ(rows[2].cells[6], "");
}

TEST(AccuracyCsv, ListsSmallObjectsApart) {
    const std::vector<AccuracyObject> objects{{"Mirror", 0.2, 0.22, {}, false, true},
                                              {"Box", 1, 1.01, {}, false, false},
                                              {"Car", 4, 4.04, {}, false, false}};
    const auto rows = parseCsv(accuracyCsv(std::vector{methodAccuracy("lidar", objects)}), "csv").value();
    EXPECT_NEAR(parseReal(rows[1].cells[4]).value(), std::sqrt((0.01 + 2 * 0.0001) / 3), 1e-12);
    EXPECT_NEAR(parseReal(rows[1].cells[7]).value(), 0.01, 1e-12);
    EXPECT_EQ(rows[1].cells[8], "Mirror");
}

TEST(ResultsJson, HoldsFractionsAndNulls) {
    const MeasuredScene scene = test::measuredExample();
    const auto accuracy = accuracyJson(scene.accuracy);
    EXPECT_EQ(accuracy[0]["name"], "lidar");
    EXPECT_EQ(accuracy[0]["excluded"], nlohmann::json::array({"Box"}));
    EXPECT_NEAR(accuracy[0]["rmse"].get<double>(), 0.01, 1e-9);
    EXPECT_TRUE(accuracy[1]["objects"][1]["measured_m"].is_null());
    EXPECT_TRUE(accuracy[1]["objects"][1]["re"].is_null());
    const auto measurements = measurementsJson(scene);
    EXPECT_EQ(measurements.size(), scene.lengths.size());
    EXPECT_EQ(measurements[0]["measured_m"].size(), 3u);
    EXPECT_TRUE(measurements[3]["measured_mean_m"].is_null());
    EXPECT_EQ(measurements[3]["note"], "hidden by trees");
}

}  // namespace
}  // namespace vestige
