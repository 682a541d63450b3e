#include "core/simulation/SimulateScene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/AtomicFile.h"
#include "core/base/Csv.h"
#include "core/base/Hash.h"
#include "core/base/Numbers.h"
#include "core/base/Parallel.h"
#include "core/io/FormatRegistry.h"
#include "tests/support/TestPaths.h"

namespace vestige {
namespace {

using Json = nlohmann::json;

/// A small yard with a box, scanned from the air from close by and by hand, quick to make.
SceneSpec yard() {
    SceneSpec spec;
    spec.name = "yard";
    const auto add = [&](const char* id, const char* kind, std::map<std::string, ParameterValue> values) {
        const ShapeKind* shape = shapeKind(kind);
        ObjectSpec object{id, shape, ParameterSet(shape->parameters()), {0, 0, 0}, 20, 0};
        for (const auto& [key, value] : values) EXPECT_TRUE(object.parameters.set(key, value));
        spec.objects.push_back(std::move(object));
    };
    add("ground", "ground", {{"width_m", 60.0}});
    add("box", "box", {{"material", std::string("cardboard")}});
    HandheldSpec layer{"side", "box", 0.002, {}};
    layer.sweeps.push_back(
        {{0.85, -0.2, 0.5}, {0.85, 0.2, 0.5}, {0.375, -0.2, 0.3}, {0.375, 0.2, 0.3}, 0.3, 0.4, 3});
    spec.handheld.push_back(layer);
    EXPECT_TRUE(spec.flight.set("radius_m", 2.0));
    EXPECT_TRUE(spec.flight.set("height_m", 4.0));
    EXPECT_TRUE(spec.flight.set("circle_s", 0.5));
    EXPECT_TRUE(spec.photogrammetry.set("reach_m", 1.0));
    spec.measurements.push_back({"Length of box", 0.75, "box.length_a", "box.length_b"});
    return spec;
}

Json json(const std::filesystem::path& file) {
    const auto text = readTextFile(file);
    EXPECT_TRUE(text);
    return Json::parse(*text);
}

Similarity fromJson(const Json& layer) {
    Similarity similarity;
    similarity.pose = *poseFromRowMajor(layer["pose"].get<std::array<double, 16>>());
    similarity.scale = layer["scale"];
    return similarity;
}

class Simulated : public testing::Test {
  protected:
    std::filesystem::path make(const std::string& name, std::uint64_t seed = 1) {
        const auto made = simulateScene(yard(), {seed, 0.5}, folder_ / name, {});
        EXPECT_TRUE(made) << made.error().sentence();
        return folder_ / name;
    }
    test::TemporaryFolder folder_;
};

TEST_F(Simulated, WritesCloudsCasesAndTruthThatAgree) {
    const auto folder = make("a");
    const Json truth = json(folder / "truth.json");
    const Json whole = json(folder / "case.json");
    const Json without = json(folder / "case-without-handheld.json");
    ASSERT_EQ(whole["layers"].size(), 3U);
    EXPECT_EQ(whole["layers"][1]["unit"], "mm");
    EXPECT_EQ(without["layers"].size(), 2U);
    EXPECT_NEAR(truth["measurements"][0]["true_m"], 0.75, 1e-9);
    EXPECT_EQ(truth["layers"]["side"]["scale"], 0.001);

    const auto aerial = fileInfo(folder / "aerial.laz");
    ASSERT_TRUE(aerial) << aerial.error().sentence();
    EXPECT_GT(aerial->bounds.min.x(), 518000) << "UTM";
    EXPECT_GT(aerial->bounds.min.y(), 4326000);
    EXPECT_EQ(aerial->creationDayYear, std::pair(76, 2025));
    EXPECT_NE(aerial->crs.find("UTM zone 50N"), std::string::npos);

    // Truth puts the handheld scan, in millimetres, on the box's face.
    const auto side = readGeometry(folder / "side.ply");
    ASSERT_TRUE(side);
    const Similarity target = fromJson(truth["layers"]["side"]);
    const Pose box = *poseFromRowMajor(truth["objects"]["box"]["pose"].get<std::array<double, 16>>());
    const PointCloud& points = side->geometry.vertices;
    ASSERT_GT(points.size(), 10000U);
    double onFace = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector3d inBox = box.inverse() * (target * points.point(i));
        onFace += std::abs(inBox.x() - 0.375) < 0.001;
    }
    EXPECT_GT(onFace / static_cast<double>(points.size()), 0.5);

    const auto rows = readCsv(folder / "side_picks.csv");
    ASSERT_TRUE(rows);
    EXPECT_EQ(rows->at(0).cells, (std::vector<std::string>{"tx", "ty", "tz", "sx", "sy", "sz"}));
    EXPECT_GE(rows->size(), 5U);
    for (std::size_t i = 1; i < rows->size(); ++i) {
        const auto number = [&](std::size_t cell) { return *parseReal(rows->at(i).cells[cell]); };
        const Eigen::Vector3d gap = target * Eigen::Vector3d(number(3), number(4), number(5)) -
                                    Eigen::Vector3d(number(0), number(1), number(2));
        EXPECT_GT(gap.norm(), 0.001);
        EXPECT_LT(gap.norm(), 0.12) << "centimetres";
    }
}

TEST_F(Simulated, AimsAreRecordedThreeTimesAndDiffer) {
    const auto folder = make("a");
    const Json whole = json(folder / "case.json");
    const Json& aims = whole["measurements"][0]["aims"]["lidar"];
    ASSERT_EQ(aims.size(), 3U);
    EXPECT_NE(aims[0][0]["pixel"], aims[1][0]["pixel"]);
    EXPECT_FALSE(whole["measurements"][0].contains("picks"));
    for (const Json& pair : aims)
        for (const Json& aim : pair) {
            ASSERT_TRUE(whole["views"].contains(aim["view"].get<std::string>()));
            EXPECT_EQ(aim["layers"].size(), 1U);
        }
}

TEST_F(Simulated, IsTheSameForAnyNumberOfThreadsAndOtherForAnotherSeed) {
    setThreadCount(1);
    const auto one = make("one");
    setThreadCount(7);
    const auto seven = make("seven");
    setThreadCount(0);
    const auto other = make("other", 2);
    for (const char* name :
         {"aerial.laz", "side.ply", "photo.ply", "side_picks.csv", "case.json", "truth.json"}) {
        EXPECT_EQ(*sha256OfFile(one / name), *sha256OfFile(seven / name)) << name;
        EXPECT_NE(*sha256OfFile(one / name), *sha256OfFile(other / name)) << name;
    }
}

TEST_F(Simulated, StopsWhenCancelledAndRefusesFoldersItCannotWrite) {
    const JobControl control;
    control.cancel();
    const auto cancelled = simulateScene(yard(), {1, 0.1}, folder_ / "c", control);
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().code, ErrorCode::cancelled);
    ASSERT_TRUE(writeTextFile(folder_ / "file", "x"));
    const auto refused = simulateScene(yard(), {1, 0.1}, folder_ / "file", {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::output);
}

}  // namespace
}  // namespace vestige
