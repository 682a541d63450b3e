#include <gtest/gtest.h>

#include <string>

#include "core/base/AtomicFile.h"
#include "core/scene/CaseFile.h"
#include "core/scene/SavedViewEdits.h"
#include "tests/core/scene/SampleScene.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using vestige::test::TemporaryFolder;

namespace {

SavedView topView(const std::string& name) {
    SavedView view;
    view.name = name;
    view.camera = fitCamera({{483000, 4375000, 30}, {483040, 4375020, 38}}, NamedView::top, 900, 600);
    view.section = SectionBox{{483010.125, 4375010.5, 33}, {4, 2, 0.1}, 0.7, true};
    view.colorMode = "class";
    view.scale = 100;
    view.inReport = false;
    return view;
}

std::string errorOf(const std::string& savedViews) {
    const TemporaryFolder folder;
    const auto file = folder / "case.json";
    EXPECT_TRUE(writeTextFile(file, R"({"vestige":1,"saved_views":)" + savedViews + "}"));
    const auto scene = readCase(file);
    if (scene) return "it was read";
    const std::string sentence = scene.error().sentence();
    return sentence.substr(std::min(sentence.size(), sentence.find("saved_views")));
}

std::string viewText(const std::string& members, const std::string& parallel = "true") {
    return R"([{"name":"A","camera":{"position":[0,0,9],"focal_point":[0,0,0],"view_up":[0,1,0],"parallel":)" +
           parallel + "}" + members + "}]";
}

}  // namespace

TEST(SavedViews, SurviveTheCaseFileExactly) {
    const TemporaryFolder folder;
    SceneState scene = test::sampleScene();
    scene.savedViews = {topView("From above"), topView("Front of the white vehicle")};
    scene.savedViews[1].camera = fitCamera({{0, 0, 0}, {1, 2, 3}}, NamedView::perspective, 800, 500);
    scene.savedViews[1].scale.reset();
    scene.savedViews[1].section.reset();
    scene.savedViews[1].colorMode.clear();
    scene.savedViews[1].inReport = true;
    ASSERT_TRUE(writeCase(folder / "case.json", scene));
    std::vector<std::string> warnings;
    const auto read = readCase(folder / "case.json", &warnings);
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_TRUE(warnings.empty());
    EXPECT_EQ(caseText(*read), caseText(scene));
    ASSERT_EQ(read->savedViews.size(), 2U);
    EXPECT_EQ(read->savedViews[0].section, scene.savedViews[0].section);
    EXPECT_EQ(read->savedViews[0].camera.position, scene.savedViews[0].camera.position);
    EXPECT_EQ(read->savedViews[0].scale, 100);
    EXPECT_FALSE(read->savedViews[0].inReport);
    EXPECT_TRUE(read->savedViews[1].inReport);
    EXPECT_FALSE(read->savedViews[1].section);
}

TEST(SavedViews, EveryEditIsUndone) {
    Scene scene(test::sampleScene());
    const std::string begun = caseText(scene.state());
    ASSERT_TRUE(scene.perform(setSavedView(topView("A"))));
    ASSERT_TRUE(scene.perform(setSavedView(topView("B"))));
    EXPECT_FALSE(scene.perform(setSavedView(topView("B")))) << "nothing changed";
    SavedView changed = topView("A");
    changed.scale = 50;
    ASSERT_TRUE(scene.perform(setSavedView(changed)));
    EXPECT_EQ(scene.undoText(), "change the view 'A'");
    EXPECT_EQ(scene.state().savedViews[0].scale, 50) << "in its place";
    EXPECT_FALSE(scene.perform(renameSavedView("A", "B"))) << "taken";
    EXPECT_FALSE(scene.perform(renameSavedView("A", "")));
    ASSERT_TRUE(scene.perform(renameSavedView("A", "C")));
    ASSERT_TRUE(scene.perform(removeSavedView("C")));
    EXPECT_FALSE(scene.perform(removeSavedView("C")));
    ASSERT_EQ(scene.state().savedViews.size(), 1U);
    scene.undo();
    EXPECT_EQ(scene.state().savedViews[0].name, "C") << "back in its place";
    while (scene.canUndo()) scene.undo();
    EXPECT_EQ(caseText(scene.state()), begun);
    while (scene.canRedo()) scene.redo();
    ASSERT_EQ(scene.state().savedViews.size(), 1U);
    EXPECT_EQ(scene.state().savedViews[0].name, "B");
    EXPECT_EQ(unusedViewName(scene.state()), "View 1");
}

TEST(SavedViews, OfAHostileFileAreRefusedWithTheirPlace) {
    EXPECT_EQ(errorOf(viewText("")), "it was read");
    EXPECT_EQ(errorOf("{}"), "saved_views: there is an object here; expected an array");
    EXPECT_EQ(errorOf(R"([{"name":""}])"), "saved_views[0].name: the text is empty; expected a name");
    EXPECT_EQ(errorOf(R"([{"name":"A"}])"), R"(saved_views[0]: the key "camera" is missing)");
    EXPECT_EQ(
        errorOf(viewText(R"(,"section":{"centre":[0,0,0],"half_size_m":[1,0,1]})")),
        "saved_views[0].section.half_size_m: a section box has no such sides; expected metres above 0, up to "
        "1e7");
    EXPECT_EQ(errorOf(viewText(R"(,"section":{"centre":[0,0,0],"half_size_m":[1,1,1e300]})")).substr(0, 34),
              "saved_views[0].section.half_size_m");
    EXPECT_EQ(errorOf(viewText(R"(,"scale":0)")),
              "saved_views[0].scale: there is 0 here; expected a whole number from 1 to 100000");
    EXPECT_EQ(
        errorOf(viewText(R"(,"scale":100)", "false")),
        "saved_views[0].scale: a view in perspective has no scale; expected a parallel camera, or no scale");
    EXPECT_EQ(errorOf(viewText(R"(,"in_report":1)")),
              "saved_views[0].in_report: there is 1 here; expected true or false");
    std::string two = viewText("");
    two.insert(two.size() - 1, "," + viewText("").substr(1, viewText("").size() - 2));
    EXPECT_EQ(errorOf(two),
              "saved_views[1].name: two saved views are called 'A'; expected names that differ");
}
