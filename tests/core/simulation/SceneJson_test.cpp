#include <gtest/gtest.h>

#include "core/base/AtomicFile.h"
#include "core/simulation/SceneModel.h"
#include "tests/support/TestPaths.h"

namespace vestige {
namespace {

class SceneJson : public testing::Test {
  protected:
    Result<SceneSpec> read(const std::string& text) {
        const auto file = folder_ / "scene.json";
        EXPECT_TRUE(writeTextFile(file, text));
        return sceneSpec(file.string());
    }
    std::string errorOf(const std::string& text) {
        const auto spec = read(text);
        return spec ? "" : spec.error().sentence();
    }

  private:
    test::TemporaryFolder folder_;
};

TEST_F(SceneJson, DescribesWhatTheBuiltInScenesDo) {
    const auto spec = read(R"({"name": "yard", "site": {"utm_zone": 33, "day": 12, "year": 2024},
        "objects": [
          {"id": "floor", "kind": "ground", "at": [0, 0, 0], "length_m": 40, "width_m": 40, "material": "concrete"},
          {"id": "van", "kind": "car", "at": [1, 2, 0], "heading_deg": 30, "length_m": 4.5, "paint": "black-paint"}],
        "flight": {"radius_m": 12, "pattern": "repetitive"},
        "photogrammetry": {"enabled": false},
        "handheld": [{"id": "mirror", "object": "van", "spacing_mm": 0.5, "sweeps": [
          {"from": [0.2, -1.2, 1.2], "at": [0.7, -1.05, 1.03], "width_m": 0.3, "height_m": 0.2, "shots": 2}]}],
        "measurements": [{"object": "Length", "tape_m": 4.5, "from": "van.length_front", "to": "van.length_rear"}]})");
    ASSERT_TRUE(spec) << spec.error().sentence();
    EXPECT_EQ(spec->site.utmZone, 33);
    EXPECT_EQ(spec->flight.real("radius_m"), 12);
    EXPECT_EQ(spec->flight.text("pattern"), "repetitive");
    EXPECT_FALSE(spec->photogrammetry.boolean("enabled"));
    EXPECT_EQ(spec->handheld.at(0).sweeps.at(0).shots, 2);
    EXPECT_DOUBLE_EQ(spec->handheld.at(0).spacing_m, 0.0005);
    const auto scene = buildScene(*spec, 1);
    ASSERT_TRUE(scene);
    const Eigen::Vector3d along = scene->surfaces.feature("van.length_front")->position -
                                  scene->surfaces.feature("van.length_rear")->position;
    EXPECT_NEAR(along.norm(), 4.5, 1e-9);
    EXPECT_NEAR(std::atan2(along.y(), along.x()), 30 * 3.14159265358979 / 180, 1e-9);
}

TEST_F(SceneJson, NamesThePlaceOfAMistake) {
    EXPECT_NE(
        errorOf(R"({"objects": [{"id": "a", "kind": "lorry", "at": [0,0,0]}]})").find("objects[0].kind"),
        std::string::npos);
    EXPECT_NE(errorOf(R"({"objects": [{"id": "a", "kind": "car", "at": [0,0]}]})").find("objects[0].at"),
              std::string::npos);
    EXPECT_NE(errorOf(R"({"objects": [{"id": "a", "kind": "car", "at": [0,0,0], "length_m": 40}]})")
                  .find("objects[0].length_m"),
              std::string::npos);
    EXPECT_NE(
        errorOf(R"({"objects": [{"id": "a", "kind": "car", "at": [0,0,0], "doors": 4}]})").find("doors"),
        std::string::npos);
    EXPECT_NE(errorOf(R"({"name": "empty"})").find("objects"), std::string::npos);
    EXPECT_FALSE(errorOf("{\"objects\": [").empty());
    EXPECT_FALSE(errorOf("[]").empty());
    EXPECT_EQ(sceneSpec("no-such-scene").error().code, ErrorCode::input);
}

TEST_F(SceneJson, AMeasurementOfAnUnknownFeatureIsRefused) {
    const auto spec = read(R"({"objects": [{"id": "a", "kind": "box", "at": [0,0,0]}],
        "measurements": [{"object": "x", "tape_m": 1, "from": "a.length_a", "to": "a.nose"}]})");
    ASSERT_TRUE(spec);
    const auto scene = buildScene(*spec, 1);
    ASSERT_FALSE(scene);
    EXPECT_NE(scene.error().sentence().find("a.nose"), std::string::npos);
}

}  // namespace
}  // namespace vestige
