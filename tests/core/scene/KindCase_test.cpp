#include <gmock/gmock.h>

#include <fstream>

#include "core/scene/CaseFile.h"
#include "core/scene/Edits.h"
#include "core/scene/KindEdits.h"
#include "core/scene/PickFrame.h"
#include "tests/core/scene/SampleScene.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;
using testing::HasSubstr;

namespace {

PickedPoint at(const std::string& layer, double x, double y, double z) {
    return {layer, {x, y, z}, {}, false};
}

Measurement yawMark() {
    Measurement mark;
    mark.object = "Yaw mark";
    mark.kind = MeasurementKind::arc;
    mark.settings = {{"drag_factor", 0.7}};
    mark.tape_m = 60;
    mark.checkTolerance_m = 0.5;
    mark.paths["aerial"] = {
        {at("aerial", 0, 1, 2), at("aerial", 1.0 / 3, 1, 2), at("aerial", 2, 1.5, 2)},
        {at("aerial", 0, 1, 2), {"front", {1, 1, 2}, 0.02, true}, at("aerial", 2, 1.5, 2)}};
    return mark;
}

Result<SceneState> readText(const std::string& measurement, std::vector<std::string>* warnings = nullptr) {
    const TemporaryFolder folder;
    const auto file = folder / "case.json";
    std::ofstream(file) << R"({"vestige": 1, "layers": [{"id": "a", "role": "aerial", "path": "a.las"}],
        "measurements": [)"
                        << measurement << "]}";
    return readCase(file, warnings);
}

}  // namespace

TEST(KindCase, GoesToTheCaseFileAndBack) {
    const TemporaryFolder folder;
    SceneState scene = sampleScene();
    scene.measurements.push_back(yawMark());
    ASSERT_TRUE(writeCase(folder / "case.json", scene));
    const auto back = readCase(folder / "case.json");
    ASSERT_TRUE(back) << back.error().sentence();
    ASSERT_NE(back->measurement("Yaw mark"), nullptr);
    EXPECT_EQ(*back->measurement("Yaw mark"), yawMark());
    EXPECT_EQ(back->measurements.size(), scene.measurements.size());
}

TEST(KindCase, SaysWhatIsWrongAndWhere) {
    const auto error = [](const std::string& text) {
        const auto read = readText(text);
        return read ? std::string("read") : read.error().sentence();
    };
    EXPECT_THAT(error(R"({"object": "x", "kind": "curve"})"),
                testing::AllOf(HasSubstr("measurements[0].kind"), HasSubstr("'curve' is no kind"),
                               HasSubstr("point-to-plane")));
    EXPECT_THAT(error(R"({"object": "x", "kind": "arc", "settings": {"drag_factor": 9}})"),
                HasSubstr("expected a number from 0 up to 2"));
    EXPECT_THAT(error(R"({"object": "x", "check_tolerance_m": -1})"), HasSubstr("check_tolerance_m"));
    EXPECT_THAT(error(R"({"object": "x", "paths": {"a": [[[1, 2]]]}})"), HasSubstr("measurements[0].paths"));
    EXPECT_THAT(error(R"({"object": "x", "paths": {"a": [[[1, 2, 1e999]]]}})"), testing::Ne("read"));
    std::string many = "[0,0,0]";
    for (int i = 0; i < 600; ++i) many += ",[0,0,0]";
    EXPECT_THAT(error(R"({"object": "x", "paths": {"a": [[)" + many + "]]}}"),
                HasSubstr("expected 500 at most"));

    std::vector<std::string> warnings;
    const auto read = readText(R"({"object": "x", "kind": "arc", "settings": {"drag": 0.7}})", &warnings);
    ASSERT_TRUE(read);
    EXPECT_TRUE(read->measurements[0].settings.empty());
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_THAT(warnings[0], HasSubstr("the kind arc has no setting 'drag'"));
}

TEST(KindEdits, KindKeepsPicksAndDropsSettingsItDoesNotHave) {
    SceneState start = sampleScene();
    start.measurements.push_back(yawMark());
    Scene scene(start);
    ASSERT_TRUE(scene.perform(setKind("Yaw mark", MeasurementKind::polyline)));
    EXPECT_EQ(scene.state().measurement("Yaw mark")->settings.size(), 1U) << "both have a drag factor";
    ASSERT_TRUE(scene.perform(setKind("Yaw mark", MeasurementKind::angle)));
    EXPECT_TRUE(scene.state().measurement("Yaw mark")->settings.empty());
    EXPECT_EQ(scene.state().measurement("Yaw mark")->paths, yawMark().paths);
    EXPECT_FALSE(scene.perform(setKind("Yaw mark", MeasurementKind::angle)));
    scene.undo();
    scene.undo();
    EXPECT_TRUE(equal(scene.state(), start));
}

TEST(KindEdits, SettingsPathsAndChecks) {
    SceneState start = sampleScene();
    start.measurements.push_back(yawMark());
    Scene scene(start);
    const auto mark = [&] { return *scene.state().measurement("Yaw mark"); };
    EXPECT_FALSE(scene.perform(setKindSetting("Yaw mark", "drag_factor", 9.0)));
    EXPECT_FALSE(scene.perform(setKindSetting("Yaw mark", "stations", 6.0)));
    EXPECT_FALSE(scene.perform(setKindSetting("Yaw mark", "drag_factor", 0.7)));
    EXPECT_TRUE(scene.perform(setKindSetting("Yaw mark", "drag_factor", std::nullopt)));
    EXPECT_TRUE(mark().settings.empty());
    EXPECT_FALSE(scene.perform(addPath("Yaw mark", "aerial", {})));
    EXPECT_FALSE(scene.perform(addPath("Yaw mark", "aerial", PickedPath(501, at("aerial", 0, 0, 0)))));
    EXPECT_TRUE(scene.perform(addPath("Yaw mark", "photo", {at("photo", 0, 0, 0)})));
    EXPECT_EQ(scene.undoText(), "pick Yaw mark, repeat 1");
    EXPECT_TRUE(scene.perform(removePath("Yaw mark", "aerial", 0)));
    EXPECT_FALSE(scene.perform(removePath("Yaw mark", "aerial", 5)));
    EXPECT_EQ(mark().paths.at("aerial").size(), 1U);
    EXPECT_FALSE(scene.perform(setCheck("Yaw mark", -0.1)));
    EXPECT_TRUE(scene.perform(setCheck("Yaw mark", std::nullopt)));
    while (scene.canUndo()) scene.undo();
    EXPECT_TRUE(equal(scene.state(), start));
    while (scene.canRedo()) scene.redo();
    EXPECT_EQ(mark().paths.size(), 2U);
    EXPECT_FALSE(mark().checkTolerance_m);
}

TEST(KindEdits, OnePointOfAPathMovesAndComesBack) {
    Scene scene(test::sampleScene());
    Measurement mark;
    mark.object = "Mark";
    mark.kind = MeasurementKind::polyline;
    mark.paths["aerial"] = {{{"aerial", {0, 0, 0}, {}, false}, {"aerial", {1, 0, 0}, {}, false}}};
    ASSERT_TRUE(scene.perform(setMeasurement(mark, "add")));
    const PickedPoint there{"aerial", {1, 1, 0}, 0.01, false};
    ASSERT_TRUE(scene.perform(movePathPoint("Mark", "aerial", 0, 1, there)));
    const auto path = [&]() -> const PickedPath& {
        return scene.state().measurement("Mark")->paths.at("aerial")[0];
    };
    EXPECT_EQ(path()[1], there);
    EXPECT_EQ(path()[0], mark.paths["aerial"][0][0]);
    EXPECT_EQ(scene.undoText(), "move pick Mark, repeat 1");
    scene.undo();
    EXPECT_EQ(path(), mark.paths["aerial"][0]);
    scene.redo();
    EXPECT_EQ(path()[1], there);
    EXPECT_FALSE(scene.perform(movePathPoint("Mark", "aerial", 0, 1, there))) << "it is there already";
    EXPECT_FALSE(scene.perform(movePathPoint("Mark", "aerial", 0, 2, there)));
    EXPECT_FALSE(scene.perform(movePathPoint("Mark", "aerial", 1, 0, there)));
    EXPECT_FALSE(scene.perform(movePathPoint("Mark", "front", 0, 0, there)));
    EXPECT_FALSE(scene.perform(movePathPoint("Nothing", "aerial", 0, 0, there)));
}

TEST(KindEdits, PathsStayOnTheirScanWhenItMoves) {
    SceneState start = sampleScene();
    Measurement mark = yawMark();
    mark.paths = {{"front", {{at("front", 1, 2, 3), at("front", 2, 2, 3), at("aerial", 3, 2, 3)}}}};
    start.measurements.push_back(mark);
    Scene scene(start);
    const auto inLayer = [&](std::size_t i) {
        const PickedPoint& point = scene.state().measurement("Yaw mark")->paths.at("front")[0][i];
        return Eigen::Vector3d(sceneFromLayer(*scene.state().layer("front")).inverse() *
                               scenePosition(scene.state(), point));
    };
    const Eigen::Vector3d before = inLayer(0);
    ASSERT_TRUE(scene.perform(setRegistration("front", sampleResult(1.5, 0.4))));
    EXPECT_LT((inLayer(0) - before).norm(), 1e-6);
    EXPECT_EQ(scene.state().measurement("Yaw mark")->paths.at("front")[0][2], at("aerial", 3, 2, 3));
    scene.undo();
    EXPECT_TRUE(equal(scene.state(), start));
}
