#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/scene/CaseFile.h"
#include "core/scene/MeasuredScene.h"
#include "core/scene/PickFrame.h"
#include "core/scene/edits/MovePicks.h"
#include "tests/core/scene/SampleScene.h"

namespace vestige {
namespace {

using Vec = Eigen::Vector3d;

FittedFeature edge(const Vec& position) {
    FittedFeature feature;
    feature.mode = SnapMode::edge;
    feature.position = position;
    feature.axis = {0, 1, 0};
    feature.axisUncertainty = 0.01;
    feature.covariance = Vec(4e-6, 1e-6, 9e-6).asDiagonal();
    feature.covariance(0, 2) = feature.covariance(2, 0) = 1e-6;
    feature.rms = 0.02;
    feature.inliers = 123;
    return feature;
}

/// The sample with a width whose ends are edges, and an aim at one.
SceneState fittedScene() {
    SceneState scene = test::sampleScene();
    Measurement width;
    width.object = "Width of box";
    width.tape_m = 0.5;
    for (const double noise : {0.01, -0.02}) {
        PickedPoint a{"aerial", {noise, 0, 1}, 0.01};
        PickedPoint b{"aerial", {0.5 - noise, 0.05, 1.03}, 0.01};
        a.fitted = edge({0.001, 0, 1});
        b.fitted = edge({0.503, 0.05, 1});
        width.picks["aerial"].push_back({a, b});
    }
    width.aims["lidar"] = {{{"side", {1, 2}, {"aerial"}, SnapMode::edge}, {"side", {3, 4}, {"aerial"}}}};
    scene.measurements.push_back(width);
    return scene;
}

TEST(FittedPicks, ComeBackFromTheCaseFile) {
    const SceneState scene = fittedScene();
    const auto file = std::filesystem::path(testing::TempDir()) / "fitted-picks.json";
    ASSERT_TRUE(writeCase(file, scene));
    std::vector<std::string> warnings;
    const auto read = readCase(file, &warnings);
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_TRUE(warnings.empty()) << warnings.front();
    EXPECT_EQ(read->measurements, scene.measurements);
}

TEST(FittedPicks, AreMeasuredBesideThePointsPicked) {
    const MeasuredScene measured = measureScene(fittedScene());
    const auto row = [&](const std::string& method) {
        return *std::find_if(measured.lengths.begin(), measured.lengths.end(), [&](const MeasuredLength& l) {
            return l.object == "Width of box" && l.method == method;
        });
    };
    const MeasuredLength single = row("lidar");
    const MeasuredLength fitted = row("lidar fitted");
    EXPECT_NEAR(single.length->repeats_m[0], Vec(0.48, 0.05, 0.03).norm(), 1e-12);
    EXPECT_NEAR(fitted.length->mean_m, 0.502, 1e-12);  // at right angles to both edges
    // The edges' own places, and their directions over the half of 0.05 m that the places lie apart along
    // them.
    EXPECT_NEAR(*fitted.length->standardUncertainty_m, std::sqrt(8e-6 + 2 * std::pow(0.025 * 0.01, 2)), 1e-9);
    EXPECT_LT(*fitted.length->expandedUncertainty_m, *single.length->expandedUncertainty_m);
    EXPECT_TRUE(fitted.fitted && !single.fitted && !fitted.small);
    // An object none of whose picks has a feature counts by its points, and says so.
    const auto other = std::find_if(measured.lengths.begin(), measured.lengths.end(), [](const auto& l) {
        return l.object == "Length of the vehicle" && l.method == "lidar fitted";
    });
    ASSERT_NE(other, measured.lengths.end());
    EXPECT_NE(other->note.find("by the points themselves"), std::string::npos);
    EXPECT_EQ(std::count_if(measured.accuracy.begin(), measured.accuracy.end(),
                            [](const MethodAccuracy& m) { return m.name == "lidar fitted"; }),
              1);
}

TEST(FittedPicks, PathsAreRowsBesideThePlainOnes) {
    SceneState scene = test::sampleScene();
    Measurement mark;
    mark.object = "Skid mark";
    mark.kind = MeasurementKind::polyline;
    Measurement heap = mark;
    heap.object = "Patch";
    heap.kind = MeasurementKind::area;
    Measurement height = mark;
    height.object = "Step";
    height.kind = MeasurementKind::vertical;
    height.picks["aerial"] = {{{"aerial", {0, 0, 1}, 0.01}, {"aerial", {1, 0, 1.5}, 0.01}}};
    for (const double noise : {0.01, -0.02}) {
        PickedPath path{
            {"aerial", {noise, 0, 1}, 0.01}, {"aerial", {2, 0, 1}, 0.01}, {"aerial", {2, 1, 1}, 0.01}};
        path[0].fitted = edge({0.001, 0, 1});
        mark.paths["aerial"].push_back(path);
        heap.paths["aerial"].push_back(path);
    }
    scene.measurements = {mark, heap, height};
    const MeasuredScene measured = measureScene(scene);
    const auto find = [&](const std::string& object, const std::string& method) -> const MeasuredLength* {
        for (const MeasuredLength& row : measured.lengths)
            if (row.object == object && row.method == method) return &row;
        return nullptr;
    };
    const MeasuredLength* plain = find("Skid mark", "lidar");
    const MeasuredLength* fitted = find("Skid mark", "lidar fitted");
    ASSERT_TRUE(plain && fitted && plain->length && fitted->length);
    EXPECT_NEAR(plain->length->mean_m, 3.005, 1e-12);
    EXPECT_NEAR(fitted->length->mean_m, 2.999, 1e-12);
    EXPECT_TRUE(fitted->fitted && !plain->fitted);
    EXPECT_LT(*fitted->length->expandedUncertainty_m, *plain->length->expandedUncertainty_m);
    EXPECT_EQ(find("Patch", "lidar fitted"), nullptr) << "an area is no length";
    // Every length has a row of every method; without features it counts by its points.
    const MeasuredLength* step = find("Step", "lidar fitted");
    ASSERT_TRUE(step && step->length);
    EXPECT_NEAR(step->length->mean_m, 0.5, 1e-12);
    EXPECT_NE(step->note.find("by the points themselves"), std::string::npos);
    EXPECT_NEAR(step->b.x(), 1, 1e-12);
    // Only a path of a length makes the method one of lengths.
    scene.measurements = {heap};
    const MeasuredScene patch = measureScene(scene);
    EXPECT_TRUE(std::none_of(patch.accuracy.begin(), patch.accuracy.end(),
                             [](const MethodAccuracy& m) { return m.name == "lidar fitted"; }));
}

TEST(FittedPicks, ObjectsUnderThreeSpotsOfTheBeamAreSmall) {
    SceneState scene = fittedScene();
    scene.measurements.back().tape_m = 0.21;
    const MeasuredScene measured = measureScene(scene);
    for (const MethodAccuracy& method : measured.accuracy) {
        if (method.name.find("lidar") == std::string::npos) continue;
        EXPECT_EQ(method.small, std::vector<std::string>{"Width of box"});
        EXPECT_NE(method.rmseLarge, method.rmseAll);
    }
}

TEST(FittedPicks, MoveWithTheirLayerAndBack) {
    SceneState scene = test::sampleScene();
    PickedPoint point{"front", {1, 2, 3}, 0.001};
    point.fitted = edge({1, 2.01, 3});
    scene.measurements[0].picks["front"] = {{point, point}};
    const SceneState before = scene;
    const Similarity from = sceneFromLayer(scene.layers[1]);
    const auto moved = changeKeepingPicks(scene, [](SceneState& s) { s.layers[1].registration.reset(); });
    const PickedPoint& now = scene.measurements[0].picks["front"][0].a;
    ASSERT_TRUE(now.fitted && now.inLayerFrame);
    EXPECT_LT((now.fitted->position - from.inverse() * point.fitted->position).norm(), 1e-9);
    EXPECT_LT((now.fitted->axis - from.pose.linear().transpose() * point.fitted->axis).norm(), 1e-12);
    // Variances follow the unit: the layer is in millimetres.
    EXPECT_NEAR(now.fitted->covariance.trace(), point.fitted->covariance.trace() / (from.scale * from.scale),
                1e-6);
    scene.layers[1].registration = before.layers[1].registration;
    restorePicks(scene, moved);
    EXPECT_EQ(scene.measurements, before.measurements);
}

}  // namespace
}  // namespace vestige
