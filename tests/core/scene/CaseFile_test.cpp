#include "core/scene/CaseFile.h"

#include <gtest/gtest.h>

#include "core/base/AtomicFile.h"
#include "tests/core/scene/SampleScene.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using vestige::test::sampleScene;
using vestige::test::TemporaryFolder;

namespace {

/// The case of the contract, word for word but for its dots.
constexpr const char* kContractCase = R"({
  "vestige": 1,
  "name": "n", "operator": "o", "site": {"lat": 0, "lon": 0, "height_m": 0},
  "layers": [
    {"id": "aerial", "role": "aerial", "path": "aerial.las", "unit": "m"},
    {"id": "front",  "role": "handheld", "path": "front.ply", "unit": "mm", "init": {"picks": "front_picks.csv"}},
    {"id": "photo",  "role": "photogrammetry", "path": "photo.ply", "unit": "m"}
  ],
  "preprocess": {"filter": "gaussian", "voxel_m": 0.2},
  "registration": {"method": "improved-ndt", "target": "aerial"},
  "measurements": [
    {"object": "Length of the vehicle", "tape_m": 4.93,
     "picks": {"aerial": [[[1,2,3],[4,5,6]], [[1,2,3],[4,5,6.5]], [[1,2,3],[4,5,7]],
                          {"a": ["front", [1,2,3]], "b": ["aerial", [4,5,6]]}], "photo": []}}
  ]
})";

SceneState read(const std::filesystem::path& file, std::vector<std::string>* warnings = nullptr) {
    auto scene = readCase(file, warnings);
    if (!scene) throw std::runtime_error(scene.error().sentence());
    return *scene;
}

}  // namespace

TEST(CaseFile, ReadsTheContractsCase) {
    const TemporaryFolder folder;
    const auto file = folder / "case.json";
    ASSERT_TRUE(writeTextFile(file, kContractCase));
    std::vector<std::string> warnings;
    const SceneState scene = read(file, &warnings);
    EXPECT_TRUE(warnings.empty()) << warnings.front();
    EXPECT_EQ(scene.name, "n");
    EXPECT_EQ(scene.operatorName, "o");
    ASSERT_TRUE(scene.site);
    ASSERT_EQ(scene.layers.size(), 3U);
    EXPECT_EQ(scene.layers[0].path, folder / "aerial.las");
    EXPECT_EQ(scene.layers[0].method, "lidar");
    EXPECT_EQ(scene.layers[0].name, "aerial");
    EXPECT_TRUE(std::holds_alternative<InitIdentity>(scene.layers[0].init));
    EXPECT_EQ(scene.layers[1].method, "lidar");
    EXPECT_EQ(scene.layers[1].unit, LengthUnit::millimetre);
    EXPECT_EQ(std::get<InitPicks>(scene.layers[1].init).picks, folder / "front_picks.csv");
    EXPECT_EQ(scene.layers[2].method, "photogrammetry");
    EXPECT_NE(scene.layers[0].tint, scene.layers[1].tint);
    EXPECT_EQ(scene.target, "aerial");
    EXPECT_EQ(scene.preprocess.text("filter"), "gaussian");
    EXPECT_EQ(scene.preprocess.optionalReal("voxel_m"), 0.2);
    EXPECT_EQ(scene.registration.text("method"), "improved-ndt");
    ASSERT_EQ(scene.measurements.size(), 1U);
    const auto& picks = scene.measurements[0].picks.at("aerial");
    ASSERT_EQ(picks.size(), 4U);
    EXPECT_EQ(picks[1].b.position, Eigen::Vector3d(4, 5, 6.5));
    EXPECT_EQ(picks[3].a.layer, "front");
    EXPECT_EQ(picks[3].b.layer, "aerial");
    EXPECT_TRUE(scene.measurements[0].picks.at("photo").empty());
}

TEST(CaseFile, RoundTripIsExact) {
    const TemporaryFolder folder;
    SceneState scene = sampleScene();
    scene.file = folder / "sub/crossing.vestige";
    for (Layer& layer : scene.layers) layer.data = nullptr;
    ASSERT_TRUE(writeCase(scene.file, scene));
    EXPECT_TRUE(std::filesystem::is_regular_file(scene.file / "case.json"));
    std::vector<std::string> warnings;
    const SceneState again = read(scene.file, &warnings);
    EXPECT_TRUE(warnings.empty());
    EXPECT_TRUE(test::equal(scene, again)) << caseText(scene) << caseText(again);
    EXPECT_TRUE(again.measurements == scene.measurements);

    const auto text = readTextFile(scene.file / "case.json");
    ASSERT_TRUE(writeCase(scene.file, again));
    EXPECT_EQ(*text, *readTextFile(scene.file / "case.json"));
}

TEST(CaseFile, PosesKeepEveryBit) {
    const TemporaryFolder folder;
    SceneState scene = sampleScene();
    Pose& pose = scene.layers[1].registration->targetFromSource.pose;
    for (int i = 0; i < 1000; ++i) pose = pose * scene.layers[1].registration->levels[0].targetFromSource;
    ASSERT_TRUE(writeCase(folder / "a.json", scene));
    EXPECT_EQ(read(folder / "a.json").layers[1].registration->targetFromSource.pose.matrix(), pose.matrix());
}

TEST(CaseFile, PathsAreRelativeToTheFileAndSurviveMovingTheFolder) {
    const TemporaryFolder folder;
    SceneState scene;
    Layer layer = test::sampleLayer("aerial", LayerRole::aerial);
    layer.path = folder / "data/aerial.las";
    scene.layers = {layer};
    scene.target = "aerial";
    ASSERT_TRUE(writeCase(folder / "cases/a.vestige", scene));
    const auto text = readTextFile(folder / "cases/a.vestige/case.json");
    EXPECT_NE(text->find("\"../../data/aerial.las\""), std::string::npos) << *text;
    EXPECT_EQ(read(folder / "cases/a.vestige").layers[0].path, folder / "data/aerial.las");
    std::filesystem::rename(folder / "cases", folder / "other");
    EXPECT_EQ(read(folder / "other/a.vestige").layers[0].path, folder / "data/aerial.las");
    EXPECT_EQ(read(folder / "other/a.vestige").name, "a");
}

TEST(CaseFile, NamesAndPathsOfAnyScript) {
    const TemporaryFolder folder;
    SceneState scene = sampleScene();
    scene.file = folder / "Fälle/現場 1.vestige";
    scene.layers[0].name = "Straße 7, \"Nord\" 測量";
    scene.layers[0].path = folder / "Fälle/Überflug/Вид.las";
    scene.layers[1].unit = LengthUnit::usSurveyFoot;
    ASSERT_TRUE(writeCase(scene.file, scene));
    const auto back = readCase(scene.file);
    ASSERT_TRUE(back) << back.error().sentence();
    EXPECT_EQ(back->layers[0].name, scene.layers[0].name);
    EXPECT_EQ(back->resolve(back->layers[0].path), scene.layers[0].path);
    EXPECT_EQ(back->layers[1].unit, LengthUnit::usSurveyFoot);
}

TEST(CaseFile, InitialPosesOfEveryForm) {
    const TemporaryFolder folder;
    const auto file = folder / "case.json";
    const auto withInit = [&](const std::string& init) {
        EXPECT_TRUE(writeTextFile(
            file, R"({"vestige":1,"layers":[{"id":"a","role":"handheld","path":"a.ply","unit":"mm")" + init +
                      "}]}"));
        return read(file).layers[0].init;
    };
    EXPECT_TRUE(std::holds_alternative<InitAuto>(withInit(R"(,"init":"auto")")));
    EXPECT_TRUE(std::holds_alternative<InitIdentity>(withInit(R"(,"init":null)")));
    const auto pose = std::get<InitPose>(
        withInit(R"(,"init":{"pose":[0,-1,0,5, 1,0,0,6, 0,0,1,7, 0,0,0,1],"scale":0.001})"));
    EXPECT_EQ(pose.targetFromSource * Eigen::Vector3d(1000, 0, 0), Eigen::Vector3d(5, 7, 7));
    // Without a scale the unit gives it.
    EXPECT_EQ(std::get<InitPose>(withInit(R"(,"init":{"pose":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]})"))
                  .targetFromSource.scale,
              0.001);
}

TEST(CaseFile, AFirstPoseMayLeadToAnotherLayer) {
    const TemporaryFolder folder;
    const auto file = folder / "case.json";
    const std::string layers = R"({"vestige":1,"layers":[{"id":"a","role":"handheld","path":"a"},
        {"id":"b","role":"handheld","path":"b","init":{"picks":"b.csv","to":"a"}},
        {"id":"c","role":"handheld","path":"c","init":{"pose":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],"to":")";
    ASSERT_TRUE(writeTextFile(file, layers + "b\"}}]}"));
    SceneState scene = read(file);
    EXPECT_EQ(referenceOf(scene.layers[0].init), "");
    EXPECT_EQ(referenceOf(scene.layers[1].init), "a");
    EXPECT_EQ(referenceOf(scene.layers[2].init), "b");
    scene.layers[2].registration.emplace();
    scene.layers[2].registration->via = {"a", "b"};
    ASSERT_TRUE(writeCase(folder / "again.vestige", scene));
    const SceneState again = read(folder / "again.vestige");
    EXPECT_EQ(referenceOf(again.layers[1].init), "a");
    EXPECT_EQ(std::get<InitPicks>(again.layers[1].init).picks, folder / "b.csv");
    EXPECT_EQ(referenceOf(again.layers[2].init), "b");
    EXPECT_EQ(again.layers[2].registration->via, (std::vector<std::string>{"a", "b"}));

    // A layer may have been removed since: the case still opens.
    ASSERT_TRUE(writeTextFile(file, layers + "gone\"}}]}"));
    std::vector<std::string> warnings;
    ASSERT_TRUE(readCase(file, &warnings));
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("layers[2].init.to: the case has no layer 'gone'"), std::string::npos)
        << warnings[0];
    ASSERT_TRUE(writeTextFile(file, layers + "c\"}}]}"));
    EXPECT_FALSE(readCase(file, nullptr));
}

TEST(CaseFile, TheTargetIsTheFirstAerialLayerUnlessTheCaseSaysOtherwise) {
    const TemporaryFolder folder;
    const auto file = folder / "case.json";
    const std::string layers = R"({"vestige":1,"layers":[{"id":"p","role":"photogrammetry","path":"p"},
        {"id":"a","role":"aerial","path":"a"}])";
    ASSERT_TRUE(writeTextFile(file, layers + "}"));
    EXPECT_EQ(read(file).target, "a");
    ASSERT_TRUE(writeTextFile(file, layers + R"(,"registration":{"target":null}})"));
    EXPECT_EQ(read(file).target, "");
    ASSERT_TRUE(writeTextFile(file, R"({"vestige":1})"));
    EXPECT_TRUE(read(file).layers.empty());
    EXPECT_EQ(read(file).target, "");
}

TEST(CaseFile, ALayerMayBeSalvaged) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeTextFile(folder / "case.json", R"({"vestige":1,"layers":[
        {"id":"a","role":"aerial","path":"a.las","salvage":true},{"id":"b","role":"aerial","path":"b.las"}]})"));
    const auto scene = readCase(folder / "case.json");
    ASSERT_TRUE(scene);
    EXPECT_TRUE(scene->layers[0].salvage);
    EXPECT_FALSE(scene->layers[1].salvage);
    ASSERT_TRUE(writeCase(folder / "again.json", *scene));
    const auto again = readCase(folder / "again.json");
    ASSERT_TRUE(again);
    EXPECT_TRUE(again->layers[0].salvage);
}

TEST(CaseFile, ALayerMayBeAPartOfItsFile) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeTextFile(folder / "case.json", R"({"vestige":1,"layers":[
        {"id":"a","role":"aerial","path":"a.las","keep_every":4},
        {"id":"b","role":"aerial","path":"b.las","box":[483000.5,0,-2,483010,5,3]}]})"));
    const auto scene = readCase(folder / "case.json");
    ASSERT_TRUE(scene) << scene.error().sentence();
    ASSERT_TRUE(writeCase(folder / "again.json", *scene));
    const auto again = readCase(folder / "again.json");
    ASSERT_TRUE(again);
    for (const auto* read : {&*scene, &*again}) {
        EXPECT_EQ(read->layers[0].keepEvery, 4U);
        EXPECT_FALSE(read->layers[0].box);
        EXPECT_EQ(read->layers[1].keepEvery, 1U);
        ASSERT_TRUE(read->layers[1].box);
        EXPECT_EQ(read->layers[1].box->min, Eigen::Vector3d(483000.5, 0, -2));
        EXPECT_EQ(read->layers[1].box->max, Eigen::Vector3d(483010, 5, 3));
    }
    for (const char* wrong : {R"("keep_every":0)", R"("box":[1,2,3])", R"("box":[2,0,0,1,1,1])"}) {
        ASSERT_TRUE(
            writeTextFile(folder / "wrong.json",
                          std::string(R"({"vestige":1,"layers":[{"id":"a","role":"aerial","path":"a.las",)") +
                              wrong + "}]}"));
        const auto refused = readCase(folder / "wrong.json");
        ASSERT_FALSE(refused) << wrong;
        EXPECT_EQ(refused.error().code, ErrorCode::input);
    }
}

TEST(CaseFile, UnknownKeysAreWarnedOf) {
    const TemporaryFolder folder;
    const auto file = folder / "case.json";
    ASSERT_TRUE(writeTextFile(file, R"({"vestige":1,"colour":"red","preprocess":{"voxl_m":1},
        "layers":[{"id":"a","role":"aerial","path":"a","uint":"mm"}]})"));
    std::vector<std::string> warnings;
    read(file, &warnings);
    ASSERT_EQ(warnings.size(), 3U);
    EXPECT_NE(warnings[0].find("case.json: colour: "), std::string::npos) << warnings[0];
    EXPECT_NE(warnings[1].find("layers[0].uint"), std::string::npos) << warnings[1];
    EXPECT_NE(warnings[2].find("preprocess.voxl_m"), std::string::npos) << warnings[2];
}

TEST(CaseFile, LooksLikeCase) {
    EXPECT_TRUE(looksLikeCase("a.vestige"));
    EXPECT_TRUE(looksLikeCase("a.vestige/"));
    EXPECT_TRUE(looksLikeCase("case.json"));
    EXPECT_FALSE(looksLikeCase("cloud.las"));
    const TemporaryFolder folder;
    EXPECT_FALSE(looksLikeCase(folder.path()));
    ASSERT_TRUE(writeTextFile(folder / "case.json", "{}"));
    EXPECT_TRUE(looksLikeCase(folder.path()));
    // A tileset is a cloud, whatever it is called; a file that says it is a case is one.
    ASSERT_TRUE(writeTextFile(folder / "tileset.json", R"({"asset":{"version":"1.0"},"root":{}})"));
    EXPECT_FALSE(looksLikeCase(folder / "tileset.json"));
    ASSERT_TRUE(writeTextFile(folder / "both.json", R"({"vestige":1,"asset":{},"root":{}})"));
    EXPECT_TRUE(looksLikeCase(folder / "both.json"));
    ASSERT_TRUE(writeTextFile(folder / "broken.json", "{"));
    EXPECT_TRUE(looksLikeCase(folder / "broken.json"));
}

TEST(CaseFile, WritingFailsWithoutTouchingWhatStoodThere) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeTextFile(folder / "blocked", "a file"));
    const auto status = writeCase(folder / "blocked/case.json", sampleScene());
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().code, ErrorCode::output);
    SceneState scene = sampleScene();
    scene.operatorName = "\xff";  // not UTF-8: JSON cannot hold it
    const auto file = folder / "case.json";
    ASSERT_TRUE(writeTextFile(file, "before"));
    EXPECT_EQ(writeCase(file, scene).error().code, ErrorCode::output);
    EXPECT_EQ(*readTextFile(file), "before");
}
