#include "core/report/CaseReport.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include "core/base/Translation.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/report/TranslateReport.h"
#include "tests/core/report/MeasuredExample.h"
#include "tests/core/report/ReportText.h"
#include "tests/support/EnglishLeft.h"

namespace vestige {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

Layer loadedLayer(const std::string& id, LayerRole role, const std::string& sha256) {
    PointCloudBuilder builder;
    builder.add({0, 0, 0});
    builder.add({10, 20, 5});
    auto data = std::make_shared<LayerData>();
    data->geometry = std::make_shared<const TriangleMesh>(TriangleMesh{std::move(builder).build(), {}});
    data->points = std::shared_ptr<const PointCloud>(data->geometry, &data->geometry->vertices);
    data->sha256 = sha256;
    data->info.format = "PLY";
    data->info.warnings = {"two comments were skipped"};
    Layer layer;
    layer.id = id;
    layer.name = id;
    layer.role = role;
    layer.path = "/somewhere/" + id + ".ply";
    layer.data = data;
    return layer;
}

class CaseReportTest : public testing::Test {
  protected:
    CaseReportTest() {
        scene.name = "Two cars";
        scene.operatorName = "M. Muster";
        scene.target = "aerial";
        scene.layers = {loadedLayer("aerial", LayerRole::aerial, std::string(64, 'a')),
                        loadedLayer("front", LayerRole::handheld, std::string(64, 'b'))};
        RegistrationResult registration;
        registration.method = "improved-ndt";
        registration.converged = true;
        registration.iterations = 31;
        registration.rmse_m = 0.0123;
        registration.overlap = 0.78;
        registration.notes = {"unit recognised as mm"};
        registration.levels = {{1.0, 12, -0.5, StopReason::step, Pose::Identity()}};
        registration.targetFromSource.scale = 0.001;
        registration.initial.scale = 0.001;
        registration.targetFromSource.pose.translation() = Eigen::Vector3d(0, 0.05, 0);
        scene.layers[1].registration = registration;
    }

    std::string text() {
        return test::textOf(caseReport({scene,
                                        measured,
                                        {"a warning"},
                                        pictures,
                                        {{"Reading", 75}},
                                        {{"Vestige", "0.1"}},
                                        "2026-11-22T07:00:00Z"}));
    }

    SceneState scene;
    MeasuredScene measured = test::measuredExample();
    std::vector<ReportPicture> pictures;
};

TEST_F(CaseReportTest, SaysOfWhichFileOnlyAPartWasRead) {
    EXPECT_THAT(text(), Not(HasSubstr("Only part of")));
    auto data = std::make_shared<LayerData>(*scene.layers[1].data);
    data->info.damage =
        "the file is damaged, byte 7: it ends; the first 2 of 9 points are whole and were read";
    scene.layers[1].data = data;
    EXPECT_THAT(text(),
                HasSubstr("Only part of front.ply could be read: the file is damaged, byte 7: it ends; the "
                          "first 2 of 9 points are whole and were read."));
}

TEST_F(CaseReportTest, HoldsWhatTheCourtAsksFor) {
    EXPECT_THAT(text(), AllOf(HasSubstr("Two cars"), HasSubstr("aerial.ply: " + std::string(64, 'a')),
                              HasSubstr("front.ply: " + std::string(64, 'b')), HasSubstr("12.3 mm"),
                              HasSubstr("78\u00a0%"), HasSubstr("unit recognised as mm"),
                              HasSubstr("50.0 mm and 0.000\u00b0"), HasSubstr("a warning"),
                              HasSubstr("two comments were skipped"), HasSubstr("\n1.25\t")));
}

TEST_F(CaseReportTest, TellsPairsAndLoopsOfAnAdjustment) {
    JointAdjustment adjustment;
    AdjustedPair pair;
    pair.to = "aerial";
    pair.from = "front";
    pair.used = true;
    pair.found = Similarity{};
    pair.overlap = 0.62;
    pair.rmse_m = 0.0081;
    pair.correction_m = 0.0042;
    AdjustedPair lost;
    lost.to = "front";
    lost.from = "rear";
    lost.whyNot = "the other pairs contradict it";
    adjustment.pairs = {pair, lost};
    adjustment.loops = {{{"aerial", "front", "left"}, 0.0123, 0.01, 31.5, 0.00002}};
    adjustment.degreesOfFreedom = 6;
    adjustment.varianceFactor = 5.25;
    adjustment.consistent = false;
    const ReportInput input{scene, measured, {}, {}, {}, {}, "2026-11-22", &adjustment};
    EXPECT_THAT(test::textOf(caseReport(input)),
                AllOf(HasSubstr("front to aerial\t\n62\u00a0%\t\n8.1\t\n4.2\t\n0.000\t\nyes\t"),
                      HasSubstr("no: the other pairs contradict it"),
                      HasSubstr("aerial \u2013 front \u2013 left \u2013 aerial\t\n12.3\t\n0.573\t\n31.5\t"),
                      HasSubstr("variance factor 5.25): the pairs disagree")));
}

TEST_F(CaseReportTest, ListsEveryParameterOfTheMethod) {
    const std::string report = text();
    for (const ParameterSet* parameters : {&scene.preprocess, &scene.registration})
        for (const auto& spec : parameters->table())
            EXPECT_THAT(report,
                        AllOf(HasSubstr("\n" + spec.label + "\t"), HasSubstr(parameters->display(spec.key))));
}

TEST_F(CaseReportTest, NamesWhatWasNotMeasurableAndWhatWasExcluded) {
    EXPECT_THAT(text(), AllOf(HasSubstr("Not measurable: Width, \"front\" (photogrammetry)"),
                              HasSubstr("Width, \"front\", photogrammetry: hidden by trees"),
                              HasSubstr("\n+20.00 *\t")));
}

TEST_F(CaseReportTest, PlacesPicturesWhereTheyBelong) {
    pictures = {{ReportPicture::Kind::overview, "", "o.png", "The site"},
                {ReportPicture::Kind::before, "front", "b.png", "Front before"},
                {ReportPicture::Kind::before, "other", "x.png", "Another layer"},
                {ReportPicture::Kind::closeUp, "Box", "c.png", "The box"}};
    const std::string report = text();
    EXPECT_LT(report.find("# The case"), report.find("The site\n"));
    EXPECT_LT(report.find("# Registration"), report.find("Front before\n"));
    EXPECT_LT(report.find("# Measured lengths"), report.find("The box\n"));
    EXPECT_THAT(report, Not(HasSubstr("Another layer")));
}

TEST_F(CaseReportTest, IsWhollyChineseWhereItIsAskedFor) {
    RegistrationResult& result = *scene.layers[1].registration;
    result.notes = {"unit recognised as mm: The file of the source says that it is in millimetres"};
    result.verdict = Verdict::doubtful;
    result.reasons = {
        "a pose 35 mm away fits as well",
        "the data do not hold the scan: it tilts about a level axis that runs roughly north-south "
        "(4\u00b0 from the y axis)"};
    result.quality.emplace();
    result.quality->restarts = {4, 3, 0.001, 0.002};
    result.quality->residuals = {0.001, {1, 20, 3}, 2};
    for (Layer& layer : scene.layers) {
        auto data = std::make_shared<LayerData>(*layer.data);
        data->info.warnings = {"not kept: alpha", "12 points without finite coordinates left out"};
        layer.data = data;
    }
    auto damaged = std::make_shared<LayerData>(*scene.layers[1].data);
    damaged->info.damage = "the last 12 bytes of the file are missing";
    scene.layers[1].data = damaged;
    JointAdjustment adjustment;
    AdjustedPair lost;
    lost.to = "front";
    lost.from = "aerial";
    lost.whyNot = "its covariance is not positive definite";
    adjustment.pairs = {lost};
    adjustment.loops = {{{"aerial", "front"}, 0.0123, 0.01, 31.5, 0.00002}};
    adjustment.degreesOfFreedom = 6;
    for (MeasuredLength& length : measured.lengths)
        if (!length.note.empty()) length.note = "picked on 'Roof', which this case does not have";
    const ReportInput input{scene,
                            measured,
                            {"the registration of front is doubtful: a pose 35 mm away fits as well"},
                            {},
                            {{"Registering the scans", 75}},
                            {{"Vestige", "0.1"}},
                            "2026-11-22T07:00:00Z",
                            &adjustment};
    setLanguage(Language::simplifiedChinese);
    const Report report = translated(caseReport(input), language());
    setLanguage(Language::english);
    EXPECT_EQ(report.title, "现场测量报告");
    EXPECT_EQ(report.date, "2026 年 11 月 22 日 07:00 (UTC)");
    EXPECT_EQ(report.caseName, "Two cars");
    const std::string chinese = test::textOf(report);
    const std::set<std::string> names{"Two cars",         "M. Muster", "aerial", "front", "Length",
                                      "Width, \"front\"", "Handle",    "Box",    "Wheel", "Carton",
                                      "Bicycle",          "alpha",     "Roof"};
    EXPECT_THAT(test::englishLeft(chinese, names), testing::IsEmpty()) << chinese;
    // What was measured is the same in every language.
    const std::string english = test::textOf(caseReport(input));
    for (const std::string& figure :
         std::vector<std::string>{"12.3", "78\u00a0%", "+20.00 *", "31.5", std::string(64, 'b')}) {
        EXPECT_THAT(english, HasSubstr(figure));
        EXPECT_THAT(chinese, HasSubstr(figure));
    }
}

TEST_F(CaseReportTest, LeavesOutSectionsWithNothingToSay) {
    scene.layers.pop_back();
    measured = {};
    const std::string report = text();
    EXPECT_THAT(report, AllOf(Not(HasSubstr("# Registration")), Not(HasSubstr("# Measured lengths")),
                              Not(HasSubstr("# Accuracy")), HasSubstr("# Evidence used")));
}

}  // namespace
}  // namespace vestige
