#include "core/scene/Cleaning.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/AtomicFile.h"
#include "core/base/Random.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/scene/CaseFile.h"
#include "core/scene/CleanedData.h"
#include "core/scene/CleaningEdits.h"
#include "core/scene/Edits.h"
#include "tests/core/scene/SampleScene.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using vestige::test::equal;
using vestige::test::sampleScene;

namespace {

const std::string kHash(64, 'a');

std::shared_ptr<const LayerData> loaded(std::size_t count, bool mesh = false) {
    Random random(7);
    PointCloudBuilder builder(Eigen::Vector3d(480000, 4370000, 30));
    PointAttributes attributes;
    for (std::size_t i = 0; i < count; ++i)
        builder.add({480000 + random.uniform(), 4370000 + random.uniform(), 30 + random.uniform()});
    auto geometry = std::make_shared<TriangleMesh>();
    geometry->vertices = std::move(builder).build();
    for (std::uint32_t i = 0; mesh && i + 2 < count; i += 2) geometry->triangles.push_back({i, i + 1, i + 2});
    auto data = std::make_shared<LayerData>();
    data->geometry = geometry;
    data->points = std::shared_ptr<const PointCloud>(data->geometry, &data->geometry->vertices);
    data->octree = std::make_shared<const Octree>(data->points);
    data->sha256 = kHash;
    return data;
}

PointSet somePoints(std::uint32_t count, double share, std::uint64_t seed) {
    Random random(seed);
    std::vector<std::uint32_t> points;
    for (std::uint32_t i = 0; i < count; ++i)
        if (random.uniform() < share) points.push_back(i);
    return PointSet::fromSorted(points);
}

/// The sample's first layer with points.
SceneState loadedScene(std::size_t count = 1000, bool mesh = false) {
    SceneState scene = sampleScene();
    scene.layers[0].data = loaded(count, mesh);
    return scene;
}

SceneObject car(const std::string& name, double share = 0.1) {
    return {name, "vehicle", "aerial",        std::make_shared<const PointSet>(somePoints(1000, share, 4)),
            1000, kHash,     {4.9, 1.8, 1.5}, "by gaps of 0.25 m",
            true};
}

SceneState changed(std::unique_ptr<SceneEdit> edit, const SceneState& before) {
    SceneState scene = before;
    EXPECT_TRUE(edit->apply(scene));
    const SceneState after = scene;
    EXPECT_FALSE(equal(after, before)) << edit->describe();
    edit->revert(scene);
    EXPECT_TRUE(equal(scene, before)) << edit->describe();
    EXPECT_TRUE(edit->apply(scene));
    EXPECT_TRUE(equal(scene, after)) << edit->describe();
    return after;
}

}  // namespace

TEST(Cleaning, LeavesTheOtherPointsAsTheyWere) {
    for (const bool mesh : {false, true}) {
        SceneState scene = loadedScene(1000, mesh);
        Layer& layer = scene.layers[0];
        const auto whole = layer.data;
        const PointSet taken = somePoints(1000, 0.2, 1);
        layer.cleaning = *withRemoved(layer, taken, {"lasso", "inside", 0});
        EXPECT_FALSE(isCleaned(*layer.data, layer.cleaning.get()));
        ASSERT_TRUE(applyCleaning(layer, {}));
        EXPECT_TRUE(isCleaned(*layer.data, layer.cleaning.get()));
        EXPECT_EQ(layer.data->points->size(), 1000 - taken.size());
        EXPECT_EQ(loadedData(layer), whole);
        for (std::uint32_t i = 0; i < layer.data->points->size(); ++i) {
            const std::uint32_t before = loadedIndex(*layer.data, i);
            ASSERT_FALSE(taken.contains(before));
            ASSERT_EQ(layer.data->points->point(i), whole->points->point(before));
        }
        EXPECT_EQ(layer.data->geometry->isMesh(), mesh);
        for (const Triangle& corners : layer.data->geometry->triangles)
            for (const std::uint32_t corner : corners) ASSERT_LT(corner, layer.data->points->size());
        const auto before = layer.data;
        ASSERT_TRUE(applyCleaning(layer, {}));
        EXPECT_EQ(layer.data, before) << "nothing is made twice";
        layer.cleaning = nullptr;
        ASSERT_TRUE(applyCleaning(layer, {}));
        EXPECT_EQ(layer.data, whole);
    }
}

TEST(Cleaning, KnowsWhichCleaningDataAreOf) {
    SceneState scene = loadedScene(200);
    Layer& layer = scene.layers[0];
    std::vector<Cleaning> all;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        Cleaning one;
        one.removed = seed == 1   ? PointSet::fromRuns({{0, 5}})
                      : seed == 2 ? PointSet::fromRuns({{195, 200}})
                      : seed == 3 ? PointSet::fromRuns({{1, 6}})
                                  : somePoints(200, seed % 2 ? 0.02 : 0.9, seed);
        one.loadedPoints = 200;
        one.sha256 = kHash;
        all.push_back(one);
    }
    for (const Cleaning& made : all) {
        const auto data = cleanedData(layer.data, made, {});
        ASSERT_TRUE(data);
        for (const Cleaning& asked : all) EXPECT_EQ(isCleaned(**data, &asked), asked.removed == made.removed);
        EXPECT_FALSE(isCleaned(**data, nullptr));
    }
}

TEST(Cleaning, AddsUpAndSaysByWhichSteps) {
    SceneState scene = loadedScene();
    Layer& layer = scene.layers[0];
    layer.cleaning = *withRemoved(layer, PointSet::fromRuns({{10, 20}}), {"lasso", "inside", 0});
    layer.cleaning = *withRemoved(layer, PointSet::fromRuns({{15, 30}}), {"outliers", "", 0});
    EXPECT_EQ(layer.cleaning->removed, PointSet::fromRuns({{10, 30}}));
    ASSERT_EQ(layer.cleaning->steps.size(), 2U);
    EXPECT_EQ(layer.cleaning->steps[0].points, 10U);
    EXPECT_EQ(layer.cleaning->steps[1].points, 10U);
    EXPECT_EQ(*withRemoved(layer, PointSet::fromRuns({{12, 18}}), {"box", "", 0}), nullptr);
    const auto nothingLeft = withRemoved(layer, PointSet::fromRuns({{0, 1000}}), {"box", "", 0});
    ASSERT_FALSE(nothingLeft);
    EXPECT_EQ(nothingLeft.error().message, "nothing would be left of the layer");
}

TEST(Cleaning, OfAnotherFileOrPartIsRefused) {
    SceneState scene = loadedScene();
    Layer& layer = scene.layers[0];
    layer.cleaning = *withRemoved(layer, PointSet::fromRuns({{10, 20}}), {"lasso", "", 0});
    EXPECT_FALSE(cleaningMismatch(layer));
    auto other = std::make_shared<LayerData>(*layer.data);
    other->sha256 = std::string(64, 'b');
    layer.data = other;
    const Status refused = applyCleaning(scene, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::input);
    EXPECT_NE(refused.error().message.find("belong to another file"), std::string::npos);
    layer.data = loaded(999);
    ASSERT_TRUE(cleaningMismatch(layer));
    EXPECT_NE(cleaningMismatch(layer)->find("expected 1000 points, found 999"), std::string::npos);
    EXPECT_EQ(layer.data->points->size(), 999U);
}

TEST(Cleaning, ComesBackFromTheCaseFile) {
    const test::TemporaryFolder folder;
    SceneState scene = loadedScene();
    Layer& layer = scene.layers[0];
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        layer.cleaning =
            *withRemoved(layer, somePoints(1000, 0.1, seed), {"lasso", "2 m deep, \"inside\"", 0});
        scene.objects.push_back(car("car " + std::to_string(seed), 0.2 * static_cast<double>(seed)));
    }
    scene.objects[1].visible = false;
    scene.objects[2].kind = "debris";
    ASSERT_TRUE(writeCase(folder / "case.json", scene));
    std::vector<std::string> warnings;
    const auto read = readCase(folder / "case.json", &warnings);
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_TRUE(warnings.empty()) << warnings.front();
    ASSERT_TRUE(read->layers[0].cleaning);
    EXPECT_EQ(*read->layers[0].cleaning, *layer.cleaning);
    ASSERT_EQ(read->objects.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(*read->objects[i].points, *scene.objects[i].points);
        EXPECT_EQ(read->objects[i].name, scene.objects[i].name);
        EXPECT_EQ(read->objects[i].kind, scene.objects[i].kind);
        EXPECT_EQ(read->objects[i].size_m, scene.objects[i].size_m);
        EXPECT_EQ(read->objects[i].visible, scene.objects[i].visible);
        EXPECT_EQ(read->objects[i].found, scene.objects[i].found);
    }
    EXPECT_EQ(caseText(*read).size(), caseText(scene).size());
}

TEST(Cleaning, InACaseFileIsCheckedAsAStrangersWord) {
    const test::TemporaryFolder folder;
    const auto errorOf = [&](const std::string& members) {
        const auto file = folder / "case.json";
        const std::string text =
            R"({"vestige":1,"layers":[{"id":"a","role":"aerial","path":"a.las","cleaning":{"of":100,"sha256":")" +
            kHash + "\"," + members + "}}]}";
        EXPECT_TRUE(writeTextFile(file, text));
        const auto scene = readCase(file);
        if (scene) return std::string("it was read");
        const std::string sentence = scene.error().sentence();
        return sentence.substr(sentence.find("layers[0].cleaning") + 18);
    };
    EXPECT_EQ(errorOf(R"("removed":"10 5 3 1")"), "it was read");
    EXPECT_EQ(errorOf(R"("removed":"0 5 3 92")"), "it was read");
    EXPECT_EQ(
        errorOf(R"("removed":"0 5 3 93")").find(".removed: the runs reach beyond the layer's 100 points"),
        0U);
    EXPECT_EQ(errorOf(R"("removed":"4294967295 4294967295 4294967295 4294967295")")
                  .find(".removed: the runs reach"),
              0U);
    EXPECT_EQ(errorOf(R"("removed":"0 100")").find(".removed: nothing is left"), 0U);
    EXPECT_EQ(errorOf(R"("removed":"")").find(".removed: there are no points here"), 0U);
    EXPECT_EQ(errorOf(R"("removed":"1 5 0 2")").find(".removed: run 2 is empty or touches"), 0U);
    EXPECT_EQ(errorOf(R"("removed":"1 0")").find(".removed: run 1 is empty or touches"), 0U);
    EXPECT_EQ(errorOf(R"("removed":"1")").find(".removed: the runs end within a pair"), 0U);
    EXPECT_EQ(errorOf(R"("removed":"1 2 ")").find(".removed: the runs end with a space"), 0U);
    EXPECT_EQ(errorOf(R"("removed":"1 -2")").find(".removed: there is no number of points at character 2"),
              0U);
    EXPECT_EQ(errorOf(R"("removed":"1  2")").find(".removed: there is no number of points at character 2"),
              0U);
    EXPECT_EQ(errorOf(R"("removed":"99999999999 2")").find(".removed: there is no number of points"), 0U);
    EXPECT_EQ(errorOf(R"("removed":"1 2","steps":[{"how":"","points":2}])").find(".steps[0].how"), 0U);
    EXPECT_EQ(errorOf(R"("removed":"1 2","steps":[{"how":"x","points":0}])").find(".steps[0].points"), 0U);
}

TEST(Cleaning, IsAnEditLikeAnyOther) {
    SceneState scene = loadedScene();
    const auto cleaning = *withRemoved(scene.layers[0], PointSet::fromRuns({{10, 20}}), {"lasso", "", 0});
    const SceneState after = changed(setCleaning("aerial", cleaning, "remove 10 points"), scene);
    EXPECT_EQ(after.layers[0].cleaning, cleaning);
    changed(setCleaning("aerial", nullptr, "bring back"), after);
    SceneState same = scene;
    EXPECT_FALSE(setCleaning("absent", cleaning, "")->apply(same));
    EXPECT_FALSE(setCleaning("aerial", nullptr, "")->apply(same));
}

TEST(Cleaning, ItsDataOutlastAChangeOfTheLayerAndItsUndo) {
    Scene scene(loadedScene());
    const auto whole = scene.state().layers[0].data;
    Layer renamed = scene.state().layers[0];
    renamed.name = "Drone";
    ASSERT_TRUE(scene.perform(changeLayer(renamed, "rename")));
    const auto cleaning =
        *withRemoved(scene.state().layers[0], PointSet::fromRuns({{10, 20}}), {"lasso", "", 0});
    scene.perform(setCleaning("aerial", cleaning, "clean"));
    const auto clean = *cleanedData(whole, *cleaning, {});
    scene.attachData("aerial", clean);
    renamed = scene.state().layers[0];
    renamed.name = "Drone, cleaned";
    ASSERT_TRUE(scene.perform(changeLayer(renamed, "rename again")));
    EXPECT_EQ(scene.state().layers[0].data, clean);
    scene.undo();
    EXPECT_EQ(scene.state().layers[0].data, clean) << "the older name, the same points";
    scene.undo();
    scene.undo();
    EXPECT_EQ(loadedData(scene.state().layers[0]), whole);
}

TEST(SceneObjects, AreAddedRenamedHiddenAndTakenBack) {
    SceneState scene = loadedScene();
    scene = changed(addObject(car("Vehicle 1")), scene);
    scene = changed(addObject(car("Vehicle 2")), scene);
    EXPECT_EQ(unusedObjectName(scene, "Vehicle 1"), "Vehicle 1 2");
    EXPECT_EQ(unusedObjectName(scene, "Vehicle"), "Vehicle");
    scene = changed(renameObject("Vehicle 1", "White van"), scene);
    scene = changed(setObjectVisible("White van", false), scene);
    scene = changed(setObjectKind("White van", "other"), scene);
    EXPECT_EQ(scene.objects[0].name, "White van");
    EXPECT_FALSE(scene.objects[0].visible);
    EXPECT_EQ(changed(removeObject("White van"), scene).objects.size(), 1U);
    SceneState same = scene;
    EXPECT_FALSE(addObject(car("White van"))->apply(same));
    EXPECT_FALSE(addObject({"none", "vehicle", "aerial", nullptr, 1000, kHash, {}, "", true})->apply(same));
    EXPECT_FALSE(renameObject("White van", "Vehicle 2")->apply(same));
    EXPECT_FALSE(setObjectKind("White van", "boat")->apply(same));
    EXPECT_FALSE(removeObject("absent")->apply(same));
    EXPECT_TRUE(belongsTo(scene.objects[0], scene.layers[0]));
    scene.layers[0].data = loaded(999);
    EXPECT_FALSE(belongsTo(scene.objects[0], scene.layers[0]));
}
