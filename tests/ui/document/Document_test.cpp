#include "ui/document/Document.h"

#include <gtest/gtest.h>

#include "core/scene/CaseFile.h"
#include "core/scene/Edits.h"
#include "tests/support/TestPaths.h"
#include "ui/document/ObjectNames.h"

namespace vestige {
namespace {

Measurement named(const std::string& object) {
    Measurement measurement;
    measurement.object = object;
    return measurement;
}

TEST(Document, TellsEveryChangeAndTakesItBack) {
    Document document;
    int changes = 0;
    QObject::connect(&document, &Document::changed, [&] { ++changes; });
    EXPECT_FALSE(document.modified());
    EXPECT_TRUE(document.perform(setMeasurement(named("mirror"), "add mirror")));
    EXPECT_EQ(changes, 1);
    EXPECT_TRUE(document.modified());
    EXPECT_EQ(document.undoText(), "add mirror");
    EXPECT_TRUE(document.perform(setTape("mirror", 0.21)));
    document.undo();
    EXPECT_EQ(document.state().measurement("mirror")->tape_m, std::nullopt);
    document.redo();
    EXPECT_EQ(document.state().measurement("mirror")->tape_m, 0.21);
    EXPECT_EQ(changes, 4);
}

TEST(Document, AnEditThatChangesNothingIsNoStep) {
    Document document;
    document.perform(setMeasurement(named("mirror"), "add mirror"));
    document.perform(setTape("mirror", 0.21));
    EXPECT_FALSE(document.perform(setTape("mirror", 0.21)));
    document.undo();
    EXPECT_EQ(document.state().measurement("mirror")->tape_m, std::nullopt);
}

TEST(Document, SeveralEditsAreOneStepAndOneSignal) {
    Document document;
    int changes = 0;
    QObject::connect(&document, &Document::changed, [&] { ++changes; });
    document.begin("two objects");
    document.perform(setMeasurement(named("a"), "add a"));
    document.perform(setMeasurement(named("b"), "add b"));
    document.end();
    EXPECT_EQ(changes, 1);
    EXPECT_EQ(document.undoText(), "two objects");
    document.undo();
    EXPECT_TRUE(document.state().measurements.empty());
}

TEST(Document, SavesAndReadsBack) {
    const test::TemporaryFolder folder;
    Document document;
    document.perform(setMeasurement(named("mirror"), "add mirror"));
    document.perform(setTape("mirror", 0.21));
    ASSERT_TRUE(document.save(folder / "night.vestige"));
    EXPECT_FALSE(document.modified());
    EXPECT_EQ(document.title(), "night");
    const auto read = readCase(folder / "night.vestige");
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_EQ(read->measurement("mirror")->tape_m, 0.21);
}

TEST(Document, SavingWhereNothingCanBeWrittenIsAnErrorAndStaysUnsaved) {
    Document document;
    document.perform(setMeasurement(named("mirror"), "add mirror"));
    const Status saved = document.save("/proc/nowhere/case.vestige");
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().code, ErrorCode::output);
    EXPECT_TRUE(document.modified());
}

TEST(ObjectNames, FirstFreeNumber) {
    SceneState scene;
    EXPECT_EQ(freeObjectName(scene), "Length 1");
    scene.measurements = {named("Length 1"), named("Length 3")};
    EXPECT_EQ(freeObjectName(scene), "Length 2");
}

}  // namespace
}  // namespace vestige
