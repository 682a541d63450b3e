#include "core/scene/Edits.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/scene/PickFrame.h"
#include "core/scene/edits/Same.h"
#include "tests/core/scene/SampleScene.h"

using namespace vestige;
using vestige::test::equal;
using vestige::test::sampleLayer;
using vestige::test::sampleResult;
using vestige::test::sampleScene;

namespace {

/// Applies, reverts, applies, reverts: each time it must be what it was. Returns the scene after.
SceneState changed(std::unique_ptr<SceneEdit> edit, const SceneState& before = sampleScene()) {
    SceneState scene = before;
    EXPECT_TRUE(edit->apply(scene));
    EXPECT_FALSE(edit->describe().empty());
    const SceneState after = scene;
    EXPECT_FALSE(equal(after, before)) << edit->describe();
    edit->revert(scene);
    EXPECT_TRUE(equal(scene, before)) << edit->describe();
    EXPECT_TRUE(edit->apply(scene));
    EXPECT_TRUE(equal(scene, after)) << edit->describe();
    edit->revert(scene);
    EXPECT_TRUE(equal(scene, before)) << edit->describe();
    return after;
}

void expectNothing(std::unique_ptr<SceneEdit> edit, const SceneState& before = sampleScene()) {
    SceneState scene = before;
    EXPECT_FALSE(edit->apply(scene)) << edit->describe();
    EXPECT_TRUE(equal(scene, before)) << edit->describe();
}

}  // namespace

TEST(LayerEdits, Add) {
    const SceneState after = changed(addLayer(sampleLayer("second", LayerRole::aerial)));
    EXPECT_EQ(after.layers.back().id, "second");
    EXPECT_EQ(after.target, "aerial");
    expectNothing(addLayer(sampleLayer("front", LayerRole::aerial)));
    expectNothing(addLayer(Layer{}));
    EXPECT_EQ(changed(addLayer(sampleLayer("first", LayerRole::aerial)), SceneState{}).target, "first");
}

TEST(LayerEdits, Remove) {
    const SceneState after = changed(removeLayer("front"));
    EXPECT_EQ(after.layers.size(), 2U);
    EXPECT_EQ(after.measurements[0].picks.count("front"), 1U);
    EXPECT_TRUE(changed(removeLayer("aerial")).target.empty());
    expectNothing(removeLayer("absent"));
}

TEST(LayerEdits, Change) {
    Layer layer = sampleScene().layers[2];
    layer.name = "Photographs";
    layer.data = nullptr;
    const SceneState after = changed(changeLayer(layer, "rename layer"));
    EXPECT_EQ(after.layers[2].name, "Photographs");
    EXPECT_TRUE(after.layers[2].data) << "the data of the same file stay";
    expectNothing(changeLayer(sampleScene().layers[2], "same"));
    layer.id = "absent";
    expectNothing(changeLayer(layer, "absent"));
}

TEST(LayerEdits, ChangeLosesNoDataAttachedMeanwhile) {
    SceneState scene = sampleScene();
    scene.layers[2].data = nullptr;
    Layer layer = scene.layers[2];
    layer.name = "Photographs";
    const auto edit = changeLayer(layer, "rename layer");
    ASSERT_TRUE(edit->apply(scene));
    const auto data = std::make_shared<const LayerData>();
    scene.layers[2].data = data;
    edit->revert(scene);
    EXPECT_EQ(scene.layers[2].data, data);
}

TEST(LayerEdits, ChangeLosesNoEvidenceNotedMeanwhile) {
    SceneState scene = sampleScene();
    scene.layers[2].evidence.reset();
    Layer layer = scene.layers[2];
    layer.name = "Photographs";
    const auto edit = changeLayer(layer, "rename layer");
    ASSERT_TRUE(edit->apply(scene));
    scene.layers[2].evidence = FileEvidence{std::string(64, 'a'), 5, ""};
    edit->revert(scene);
    EXPECT_EQ(scene.layers[2].evidence, (FileEvidence{std::string(64, 'a'), 5, ""}));
}

/// What a layer can differ in that makes other points of the same file.
std::vector<Layer> otherPartsOf(const Layer& layer) {
    std::vector<Layer> others(4, layer);
    others[0].keepEvery = 5;
    others[1].box = BoundingBox{{0, 0, 0}, {1, 1, 1}};
    others[2].salvage = !layer.salvage;
    others[3].path = "/data/other.ply";
    return others;
}

TEST(LayerEdits, DataGoToNoOtherPartOfTheFile) {
    SceneState scene = sampleScene();
    scene.layers[2].data = nullptr;
    for (const Layer& part : otherPartsOf(scene.layers[2])) {
        const auto edit = changeLayer(part, "load a part");
        ASSERT_TRUE(edit->apply(scene));
        scene.layers[2].data = std::make_shared<const LayerData>();
        edit->revert(scene);
        EXPECT_FALSE(scene.layers[2].data);
        SceneState recovered = scene;
        recovered.layers[2] = part;
        recovered.layers[2].data = std::make_shared<const LayerData>();
        const auto restore = restoreState(recovered, "recover");
        ASSERT_TRUE(restore->apply(scene));
        EXPECT_TRUE(scene.layers[2].data);
        restore->revert(scene);
        EXPECT_FALSE(scene.layers[2].data);
    }
}

TEST(CaseEdits, RestoringKeepsWhatWasReadMeanwhile) {
    SceneState scene = sampleScene();
    scene.layers[2].data = nullptr;
    scene.layers[2].evidence.reset();
    SceneState other = scene;
    other.operatorName = "another";
    const auto edit = restoreState(other, "recover");
    ASSERT_TRUE(edit->apply(scene));
    const auto data = std::make_shared<const LayerData>();
    scene.layers[2].data = data;
    scene.layers[2].evidence = FileEvidence{std::string(64, 'a'), 5, ""};
    edit->revert(scene);
    EXPECT_NE(scene.operatorName, "another");
    EXPECT_EQ(scene.layers[2].data, data);
    EXPECT_EQ(scene.layers[2].evidence->sha256, std::string(64, 'a'));
}

TEST(LayerEdits, Visible) {
    EXPECT_TRUE(changed(setLayerVisible("photo", true)).layers[2].visible);
    expectNothing(setLayerVisible("aerial", true));
    expectNothing(setLayerVisible("absent", true));
}

TEST(LayerEdits, UnusedIds) {
    EXPECT_EQ(unusedLayerId(sampleScene(), "side"), "side");
    EXPECT_EQ(unusedLayerId(sampleScene(), "front"), "front-2");
    EXPECT_EQ(unusedLayerId(sampleScene(), ""), "layer");
}

TEST(RegistrationEdits, PicksMoveAlongWithTheirLayer) {
    const SceneState before = sampleScene();
    const PickedPoint& pick = before.measurements[0].picks.at("front")[0].a;
    const Eigen::Vector3d onLayer = sceneFromLayer(before.layers[1]).inverse() * pick.position;
    const SceneState after = changed(setRegistration("front", sampleResult(3, 1)));
    const PickedPoint& moved = after.measurements[0].picks.at("front")[0].a;
    EXPECT_LT((sceneFromLayer(after.layers[1]) * onLayer - moved.position).norm(), 1e-12);
    EXPECT_EQ(after.measurements[0].picks.at("front")[0].b, before.measurements[0].picks.at("front")[0].b);
    expectNothing(setRegistration("front", sampleResult(0.1, 0.2)));
    expectNothing(setRegistration("absent", sampleResult(0.1, 0.2)));
}

TEST(RegistrationEdits, DroppingARegistrationLeavesPicksOnTheirPoints) {
    const SceneState after = changed(setRegistration("front", std::nullopt));
    const PickedPoint& pick = after.measurements[0].picks.at("front")[0].a;
    EXPECT_TRUE(pick.inLayerFrame);
    const Eigen::Vector3d back = sampleResult(0.1, 0.2).targetFromSource * pick.position;
    EXPECT_LT((back - Eigen::Vector3d(1, 2, 3)).norm(), 1e-9);
}

TEST(RegistrationEdits, PicksOfACaseFileAreInTheTargetsFrameAlready) {
    SceneState before = sampleScene();
    before.layers[1].registration.reset();
    const SceneState after = changed(setRegistration("front", sampleResult(3, 1)), before);
    EXPECT_EQ(after.measurements, before.measurements);
}

TEST(RegistrationEdits, PicksMadeBeforeTheRegistrationMoveIntoTheTargetsFrame) {
    const SceneState after = changed(setRegistration("photo", sampleResult(3, 1)));
    const PickedPoint& pick = after.measurements[1].picks.at("photo")[0].a;
    EXPECT_FALSE(pick.inLayerFrame);
    EXPECT_LT((pick.position - sampleResult(3, 1).targetFromSource * Eigen::Vector3d(1, 1, 1)).norm(), 1e-12);
}

TEST(RegistrationEdits, Target) {
    const SceneState before = sampleScene();
    const SceneState after = changed(setTarget("photo"));
    EXPECT_EQ(after.target, "photo");
    EXPECT_FALSE(after.layers[1].registration);
    EXPECT_TRUE(after.measurements[0].picks.at("aerial")[0].a.inLayerFrame);
    EXPECT_FALSE(after.measurements[1].picks.at("photo")[0].a.inLayerFrame);
    EXPECT_EQ(scenePosition(after, after.measurements[1].picks.at("photo")[0].a), Eigen::Vector3d(1, 1, 1));
    expectNothing(setTarget("aerial"));
    expectNothing(setTarget("absent"));
}

TEST(ParameterEdits, SetWhatIsAllowed) {
    EXPECT_EQ(changed(setPreprocessParameter("voxel_m", 0.5)).preprocess.optionalReal("voxel_m"), 0.5);
    EXPECT_FALSE(
        changed(setPreprocessParameter("voxel_m", std::monostate{})).preprocess.optionalReal("voxel_m"));
    EXPECT_EQ(changed(setRegistrationParameter("method", std::string("icp"))).registration.text("method"),
              "icp");
    expectNothing(setPreprocessParameter("voxel_m", 0.2));
    expectNothing(setPreprocessParameter("voxel_m", -1.0));
    expectNothing(setPreprocessParameter("filter", 3.0));
    expectNothing(setRegistrationParameter("absent", 0.2));
}

TEST(MeasurementEdits, AddAndReplace) {
    Measurement box;
    box.object = "Box";
    EXPECT_EQ(changed(setMeasurement(box, "measure Box")).measurements.back(), box);
    Measurement mirror = sampleScene().measurements[1];
    expectNothing(setMeasurement(mirror, "same"));
    mirror.tape_m = 0.22;
    EXPECT_EQ(changed(setMeasurement(mirror, "change")).measurements[1].tape_m, 0.22);
    expectNothing(setMeasurement(Measurement{}, "no name"));
}

TEST(MeasurementEdits, RemoveRenameTape) {
    EXPECT_EQ(changed(removeMeasurement("Length of the vehicle")).measurements.size(), 1U);
    expectNothing(removeMeasurement("absent"));
    const SceneState renamed = changed(renameMeasurement("Right rearview mirror", "Mirror"));
    EXPECT_TRUE(renamed.measurement("Mirror"));
    expectNothing(renameMeasurement("Right rearview mirror", "Length of the vehicle"));
    expectNothing(renameMeasurement("Right rearview mirror", ""));
    expectNothing(renameMeasurement("absent", "x"));
    EXPECT_EQ(changed(setTape("Right rearview mirror", 0.22)).measurements[1].tape_m, 0.22);
    EXPECT_FALSE(changed(setTape("Length of the vehicle", std::nullopt)).measurements[0].tape_m);
    expectNothing(setTape("Length of the vehicle", 4.93));
    expectNothing(setTape("Length of the vehicle", 0));
    expectNothing(setTape("Length of the vehicle", std::numeric_limits<double>::quiet_NaN()));
    expectNothing(setTape("absent", 1));
}

TEST(PickEdits, AddAndRemove) {
    const PickedPair pair{{"aerial", {1, 2, 3}, 0.01, false}, {"aerial", {2, 2, 3}, {}, false}};
    const auto edit = addPick("Length of the vehicle", "aerial", pair);
    EXPECT_EQ(
        changed(addPick("Length of the vehicle", "aerial", pair)).measurements[0].picks.at("aerial").size(),
        3U);
    SceneState scene = sampleScene();
    ASSERT_TRUE(edit->apply(scene));
    EXPECT_EQ(edit->describe(), "pick Length of the vehicle, repeat 3");
    EXPECT_EQ(changed(addPick("Right rearview mirror", "aerial", pair)).measurements[1].picks.size(), 2U);
    expectNothing(addPick("absent", "aerial", pair));

    const SceneState after = changed(removePick("Length of the vehicle", "aerial", 0));
    EXPECT_EQ(after.measurements[0].picks.at("aerial").size(), 1U);
    EXPECT_EQ(after.measurements[0].picks.at("aerial")[0],
              sampleScene().measurements[0].picks.at("aerial")[1]);
    expectNothing(removePick("Length of the vehicle", "aerial", 2));
    expectNothing(removePick("Length of the vehicle", "absent", 0));
    expectNothing(removePick("absent", "aerial", 0));
}

TEST(PickEdits, MoveOneEnd) {
    const PickedPair before = sampleScene().measurements[0].picks.at("aerial")[1];
    PickedPoint point{"aerial", {7, 8, 9}, 0.02, false};
    point.fitted = FittedFeature{.mode = SnapMode::edge, .position = {7, 8, 9.01}};
    const auto edit = movePick("Length of the vehicle", "aerial", 1, true, point);
    EXPECT_EQ(edit->describe(), "move pick Length of the vehicle, repeat 2");
    const SceneState after = changed(movePick("Length of the vehicle", "aerial", 1, true, point));
    EXPECT_EQ(after.measurements[0].picks.at("aerial")[1].b, point);
    EXPECT_EQ(after.measurements[0].picks.at("aerial")[1].a, before.a);
    EXPECT_EQ(changed(movePick("Length of the vehicle", "aerial", 1, false, point))
                  .measurements[0]
                  .picks.at("aerial")[1]
                  .b,
              before.b);
    expectNothing(movePick("Length of the vehicle", "aerial", 1, true, before.b));
    expectNothing(movePick("Length of the vehicle", "aerial", 2, true, point));
    expectNothing(movePick("Length of the vehicle", "absent", 0, true, point));
    expectNothing(movePick("absent", "aerial", 0, true, point));
}

TEST(CaseEdits, DetailsAndViews) {
    EXPECT_EQ(changed(setCaseDetails("Other", "Operator", std::nullopt)).name, "Other");
    expectNothing(setCaseDetails("Crossing", "M\xc3\xbcller, \"K\"", Site{52.1, -0.3, 34.5}));
    ViewCamera camera;
    camera.position = {1, 2, 3};
    EXPECT_TRUE(same(changed(setView("new", camera)).views.at("new"), camera));
    EXPECT_EQ(changed(setView("side", camera)).viewFrames.count("side"), 0U);
    EXPECT_EQ(changed(removeView("side")).views.count("side"), 0U);
    expectNothing(setView("top", ViewCamera{}));
    expectNothing(removeView("absent"));
}
