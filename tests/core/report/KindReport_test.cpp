#include <nlohmann/json.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <cmath>

#include "core/base/Csv.h"
#include "core/base/Numbers.h"
#include "core/report/CaseReport.h"
#include "core/report/CheckBlocks.h"
#include "core/report/ChecksJson.h"
#include "core/report/QuantitiesCsv.h"
#include "core/report/QuantityText.h"
#include "tests/core/report/ReportText.h"

namespace vestige {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

PickedPoint at(double x, double y, double z) {
    return {"aerial", {x, y, z}, 0.01, false};
}

/// A yaw mark of 60 m radius traced three times, a crushed front, and a scale bar of 2 m.
SceneState kindsScene() {
    SceneState scene;
    Layer layer;
    layer.id = layer.name = "aerial";
    layer.method = "lidar";
    scene.layers = {layer};
    scene.target = "aerial";
    Measurement yaw, front, bar;
    yaw.object = "Yaw mark";
    yaw.kind = MeasurementKind::arc;
    yaw.settings = {{"drag_factor", 0.7}};
    for (const double off : {0.0, 0.01, -0.01}) {
        PickedPath path;
        for (int i = 0; i < 9; ++i)
            path.push_back(at(60 * std::cos(0.05 * i), 60 * std::sin(0.05 * i) + (i % 2 ? off : 0), 0));
        yaw.paths["aerial"].push_back(path);
    }
    front.object = "Front";
    front.kind = MeasurementKind::crush;
    front.paths["aerial"] = {
        {at(0, 0, 0.5), at(1.8, 0, 0.5), at(0, 0.1, 0.5), at(0.9, 0.5, 0.5), at(1.8, 0.2, 0.5)}};
    bar.object = "Scale bar";
    bar.tape_m = 2;
    bar.checkTolerance_m = 0.01;
    for (const double length : {2.003, 2.004, 2.002})
        bar.picks["aerial"].push_back({at(0, 0, 0), at(length, 0, 0)});
    scene.measurements = {yaw, front, bar};
    return scene;
}

TEST(KindReport, TellsFiguresBudgetsAndCharts) {
    // caseReport asks loaded layers for their files; the sections of figures alone do not.
    const SceneState scene = kindsScene();
    const MeasuredScene measured = measureScene(scene);
    const ReportInput input{scene, measured, {}, {}, {}, {}, "2026-11-28", nullptr};
    Report report;
    report.sections = {kindSection(input), uncertaintySection(input), checkSection(input)};
    const std::string text = test::textOf(report);
    EXPECT_THAT(text, AllOf(HasSubstr("Arc (yaw mark)"), HasSubstr("\nRadius by fit\t"),
                            HasSubstr("\nCritical speed, radius by fit\t"), HasSubstr("Found with"),
                            HasSubstr("\n0.7\t"), HasSubstr("\nC6\t"),
                            HasSubstr("Front, lidar: crush in plan"), HasSubstr("undamaged outline")));
    EXPECT_THAT(text, AllOf(HasSubstr("\nrepeats\t"), HasSubstr("\nsensor noise\t"),
                            HasSubstr("\npoint spacing\t"), HasSubstr("rectangular")));
    EXPECT_THAT(text, HasSubstr("\npassed\t"));
    EXPECT_THAT(text, HasSubstr("is verified"));
}

TEST(KindReport, SaysVerifiedOnlyWithAPassedCheckAndShoutsAFailedOne) {
    SceneState scene = kindsScene();
    EXPECT_THAT(verificationSentence(measureScene(scene)),
                AllOf(HasSubstr("is verified"), Not(HasSubstr("not verified"))));
    scene.measurements[2].checkTolerance_m = 0.001;
    const MeasuredScene failed = measureScene(scene);
    EXPECT_THAT(verificationSentence(failed),
                AllOf(HasSubstr("FAILED for lidar"), Not(HasSubstr("verified"))));
    ASSERT_EQ(failedChecks(failed).size(), 1U);
    EXPECT_THAT(failedChecks(failed)[0],
                AllOf(HasSubstr("Scale bar by lidar"), HasSubstr("3.0 mm off where 1.0 mm")));
    EXPECT_EQ(checksJson(failed)["verification"], "failed");
    scene.measurements[2].checkTolerance_m.reset();
    const MeasuredScene open = measureScene(scene);
    EXPECT_THAT(verificationSentence(open), HasSubstr("was not verified"));
    EXPECT_TRUE(failedChecks(open).empty());
    EXPECT_EQ(checksJson(open)["verification"], "not verified");
    EXPECT_THAT(verificationSentence({}), HasSubstr("was not verified"));
}

TEST(QuantitiesCsv, HasEveryFigureAndEveryLineOfItsBudget) {
    const MeasuredScene measured = measureScene(kindsScene());
    const auto rows = parseCsv(quantitiesCsv(measured), "csv").value();
    const auto budget = parseCsv(uncertaintyCsv(measured), "csv").value();
    ASSERT_EQ(rows[0].cells.size(), 17U);
    std::size_t figures = 0, lines = 0;
    for (const auto& kind : measured.kinds)
        for (const auto& each : kind.quantities) {
            ++figures;
            lines += each.budget.contributions.size();
        }
    EXPECT_EQ(rows.size(), figures + 1);
    EXPECT_EQ(budget.size(), lines + 1);
    EXPECT_EQ(rows[1].cells[0], "Yaw mark");
    EXPECT_EQ(rows[1].cells[1], "arc");
    EXPECT_EQ(rows[1].cells[2], "radius_fit");
    EXPECT_EQ(rows[1].cells[3], "m");
    EXPECT_EQ(rows[1].cells[5], "3");
    EXPECT_EQ(parseReal(rows[1].cells[6]), measured.kinds[0].quantities[0].mean);
    double shares = 0;
    for (const auto& row : budget)
        if (row.cells[0] == "Yaw mark" && row.cells[2] == "radius_fit") shares += *parseReal(row.cells[12]);
    EXPECT_NEAR(shares, 1, 1e-12);
}

TEST(QuantitiesJson, HasBudgetsAndNullsForWhatThereIsNot) {
    const auto list = quantitiesJson(measureScene(kindsScene()));
    EXPECT_EQ(list[0]["quantity"], "radius_fit");
    EXPECT_EQ(list[0]["repeats"].size(), 3U);
    EXPECT_FALSE(list[0]["budget"].empty());
    for (const auto& each : list)
        if (each["object"] == "Front") {
            EXPECT_TRUE(each["expanded_uncertainty"].is_null()) << "traced once";
            EXPECT_TRUE(each["interval"][0].is_null());
        }
}

TEST(QuantityText, KeepsTheDigitsThatMeanSomething) {
    QuantityStatistic radius{"radius_fit", "Radius by fit", QuantityUnit::metre, {64.04}};
    radius.mean = 64.04;
    EXPECT_EQ(quantitySentence(radius), "64.040 m");
    radius.expandedUncertainty = 6.2;
    radius.low = 58.6;
    radius.high = 70.6;
    EXPECT_EQ(quantitySentence(radius), "64.0 m (58.6 to 70.6 m)");
    radius.high = INFINITY;
    EXPECT_EQ(quantityIntervalText(radius), "58.6 or more");
    QuantityStatistic angle{"angle", "Angle", QuantityUnit::degree, {45.123}};
    angle.mean = 45.123;
    angle.expandedUncertainty = 0.25;
    angle.low = 44.873;
    angle.high = 45.373;
    EXPECT_EQ(quantitySentence(angle), "45.12\u00b0 \u00b1 0.25\u00b0");
}

}  // namespace
}  // namespace vestige
