#include "core/scene/Scene.h"

#include <gtest/gtest.h>

#include "core/scene/Edits.h"
#include "tests/core/scene/SampleScene.h"

using namespace vestige;
using vestige::test::equal;
using vestige::test::sampleScene;

TEST(Scene, UndoAndRedoWithTheirTexts) {
    Scene scene(sampleScene());
    EXPECT_FALSE(scene.canUndo() || scene.canRedo());
    EXPECT_TRUE(scene.perform(setTape("Right rearview mirror", 0.2)));
    EXPECT_TRUE(scene.perform(removeLayer("photo")));
    EXPECT_EQ(scene.undoText(), "remove layer 'photo'");
    scene.undo();
    EXPECT_EQ(scene.redoText(), "remove layer 'photo'");
    EXPECT_EQ(scene.undoText(), "set the tape of Right rearview mirror");
    scene.undo();
    EXPECT_TRUE(equal(scene.state(), sampleScene()));
    scene.undo();
    scene.redo();
    EXPECT_EQ(scene.state().measurements[1].tape_m, 0.2);
}

TEST(Scene, WhatChangesNothingDoesNotEnterTheHistory) {
    Scene scene(sampleScene());
    int changes = 0;
    scene.onChange([&] { ++changes; });
    ASSERT_TRUE(scene.perform(setTape("Right rearview mirror", 0.2)));
    scene.undo();
    EXPECT_FALSE(scene.perform(setTape("absent", 0.2)));
    EXPECT_FALSE(scene.perform(nullptr));
    EXPECT_TRUE(scene.canRedo()) << "what was undone stays";
    EXPECT_FALSE(scene.canUndo());
    EXPECT_EQ(changes, 2);
    EXPECT_FALSE(scene.modified());
}

TEST(Scene, ANewStepDropsWhatWasUndone) {
    Scene scene(sampleScene());
    scene.perform(setTape("Right rearview mirror", 0.2));
    scene.undo();
    scene.perform(setTape("Right rearview mirror", 0.3));
    EXPECT_FALSE(scene.canRedo());
}

TEST(Scene, KnowsWhetherItIsSavedThroughUndoAndRedo) {
    Scene scene(sampleScene());
    EXPECT_FALSE(scene.modified());
    scene.perform(setTape("Right rearview mirror", 0.2));
    EXPECT_TRUE(scene.modified());
    scene.markSaved("/cases/b.vestige");
    EXPECT_FALSE(scene.modified());
    EXPECT_EQ(scene.state().file, "/cases/b.vestige");
    scene.perform(setTape("Right rearview mirror", 0.3));
    scene.undo();
    EXPECT_FALSE(scene.modified()) << "back at what was saved";
    scene.undo();
    EXPECT_TRUE(scene.modified());
    scene.redo();
    EXPECT_FALSE(scene.modified());
    scene.undo();
    scene.perform(setTape("Right rearview mirror", 0.4));
    EXPECT_TRUE(scene.modified()) << "as many steps as when saved, but another one";
    scene.undo();
    EXPECT_TRUE(scene.modified()) << "what was saved cannot be reached any more";
}

TEST(Scene, GroupsAreOneStep) {
    Scene scene(sampleScene());
    scene.begin("tape both");
    scene.perform(setTape("Right rearview mirror", 0.2));
    EXPECT_FALSE(scene.canUndo()) << "a step that is not complete cannot be undone";
    EXPECT_TRUE(scene.modified());
    scene.begin("inner");
    scene.perform(setTape("Length of the vehicle", 5.0));
    scene.end();
    EXPECT_FALSE(scene.canUndo());
    scene.end();
    EXPECT_EQ(scene.undoText(), "tape both");
    scene.undo();
    EXPECT_TRUE(equal(scene.state(), sampleScene()));
    EXPECT_FALSE(scene.canUndo());
    scene.redo();
    EXPECT_EQ(scene.state().measurements[0].tape_m, 5.0);
    scene.end();  // without begin: nothing
    scene.begin("empty");
    scene.end();
    EXPECT_EQ(scene.undoText(), "tape both");
}

TEST(Scene, DataThatReplaceAPreviewReachTheHistoryToo) {
    Scene scene(sampleScene());
    const auto preview = std::make_shared<const LayerData>();
    const auto whole = std::make_shared<const LayerData>();
    Layer added;
    added.id = "large";
    added.data = preview;
    scene.perform(addLayer(added));
    Layer renamed = added;
    renamed.name = "Large";
    scene.perform(changeLayer(renamed, "rename"));
    scene.undo();
    scene.undo();
    ASSERT_FALSE(scene.state().layer("large"));
    scene.replaceData(preview, whole);
    scene.redo();
    EXPECT_EQ(scene.state().layer("large")->data, whole);
    scene.redo();
    EXPECT_EQ(scene.state().layer("large")->data, whole);
    EXPECT_EQ(scene.state().layer("large")->name, "Large");
    scene.replaceData(whole, nullptr);
    EXPECT_FALSE(scene.state().layer("large")->data);
}

TEST(Scene, WhatWasReplacedIsNotKeptOnceNobodyHoldsIt) {
    Scene scene(sampleScene());
    auto preview = std::make_shared<const LayerData>();
    auto whole = std::make_shared<const LayerData>();
    const std::weak_ptr<const LayerData> kept = whole;
    scene.attachData("photo", preview);
    scene.replaceData(preview, whole);
    scene.attachData("photo", nullptr);
    preview = whole = nullptr;
    scene.perform(setTape("Right rearview mirror", 0.2));
    EXPECT_TRUE(kept.expired());
}

TEST(Scene, AFileThatBecomesKnownAfterItsStepIsAChange) {
    const auto preview = std::make_shared<const LayerData>();
    auto read = std::make_shared<LayerData>();
    read->sha256 = std::string(64, 'a');
    Scene scene(sampleScene());
    Layer added = test::sampleLayer("large", LayerRole::handheld);
    added.data = preview;
    scene.perform(addLayer(added));
    const std::uint64_t step = scene.step();
    scene.markSaved("/cases/a.vestige");
    ASSERT_FALSE(scene.modified());
    scene.replaceData(preview, read);
    EXPECT_EQ(scene.state().layer("large")->evidence->sha256, read->sha256);
    EXPECT_EQ(scene.step(), step);
    EXPECT_EQ(scene.notes(), 1U);
    EXPECT_TRUE(scene.modified()) << "the saved case does not know the file";
    scene.undo();
    scene.redo();
    EXPECT_TRUE(scene.modified());
    scene.markSaved("/cases/a.vestige");
    EXPECT_FALSE(scene.modified());
    scene.attachData("photo", read);
    EXPECT_FALSE(scene.modified()) << "loading a case as it was opened changes nothing of it";
    EXPECT_EQ(scene.notes(), 1U);
}

TEST(Scene, AFileThatBecomesKnownWhileItsLayerIsAwayIsAChangeToo) {
    const auto preview = std::make_shared<const LayerData>();
    auto read = std::make_shared<LayerData>();
    read->sha256 = std::string(64, 'a');
    Scene scene(sampleScene());
    Layer added = test::sampleLayer("large", LayerRole::handheld);
    added.data = preview;
    scene.perform(addLayer(added));
    scene.markSaved("/cases/a.vestige");
    scene.perform(removeLayer("large"));
    scene.replaceData(preview, read);
    scene.undo();
    EXPECT_EQ(scene.state().layer("large")->evidence->sha256, read->sha256);
    EXPECT_TRUE(scene.modified()) << "the saved case does not know the file";
}

TEST(Scene, AttachedDataAreNoStep) {
    Scene scene(sampleScene());
    const auto data = std::make_shared<const LayerData>();
    scene.attachData("photo", data);
    scene.attachData("absent", data);
    EXPECT_EQ(scene.state().layers[2].data, data);
    EXPECT_FALSE(scene.modified() || scene.canUndo());
}
