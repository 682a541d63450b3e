#include "core/scene/MeasuredScene.h"

#include <gtest/gtest.h>

#include "core/geometry/PointCloudBuilder.h"
#include "tests/core/scene/SampleScene.h"

using namespace vestige;
using vestige::test::sampleLayer;
using vestige::test::sampleResult;

namespace {

PickedPair pair(const std::string& layer, double length) {
    return {{layer, {0, 0, 0}, 0.0, false}, {layer, {length, 0, 0}, 0.0, false}};
}

SceneState threeLayers() {
    SceneState scene;
    scene.layers = {sampleLayer("aerial", LayerRole::aerial), sampleLayer("front", LayerRole::handheld),
                    sampleLayer("photo", LayerRole::photogrammetry)};
    for (Layer& layer : scene.layers) layer.data = nullptr;
    scene.layers[1].registration = sampleResult(0.1, 0.2);
    scene.target = "aerial";
    Measurement box;
    box.object = "Box";
    box.tape_m = 0.75;
    scene.measurements = {box};
    return scene;
}

}  // namespace

TEST(MeasuredScene, OneRowPerObjectAndMethod) {
    SceneState scene = threeLayers();
    scene.measurements[0].picks["aerial"] = {pair("aerial", 0.76), pair("aerial", 0.78),
                                             pair("aerial", 0.77)};
    const MeasuredScene measured = measureScene(scene);
    ASSERT_EQ(measured.lengths.size(), 2U);
    const MeasuredLength& lidar = measured.lengths[0];
    EXPECT_EQ(lidar.method, "lidar");
    EXPECT_EQ(lidar.layers, std::vector<std::string>{"aerial"});
    EXPECT_NEAR(lidar.length->mean_m, 0.77, 1e-12);
    EXPECT_NEAR(*lidar.re, 0.02 / 0.75, 1e-12);
    EXPECT_NEAR(*lidar.length->standardUncertainty_m, std::sqrt(0.0001 / 3 + 2 * 0.0009), 1e-12);
    EXPECT_TRUE(lidar.note.empty()) << lidar.note;
    const MeasuredLength& photo = measured.lengths[1];
    EXPECT_EQ(photo.method, "photogrammetry");
    EXPECT_FALSE(photo.length);
    EXPECT_FALSE(photo.re);
    EXPECT_EQ(photo.note, "not measured with this method");
    ASSERT_EQ(measured.accuracy.size(), 2U);
    EXPECT_EQ(measured.accuracy[0].n, 1U);
    EXPECT_EQ(measured.accuracy[1].n, 0U);
}

TEST(MeasuredScene, UnregisteredLayersAreMeasuredInTheirOwnUnit) {
    SceneState scene = threeLayers();
    scene.layers[1].registration.reset();
    scene.measurements[0].picks["front"] = {pair("front", 751), pair("front", 749)};
    const MeasuredScene measured = measureScene(scene);
    EXPECT_NEAR(measured.lengths[0].length->mean_m, 0.75, 1e-12);
    EXPECT_EQ(measured.lengths[0].layers, std::vector<std::string>{"front"});
}

TEST(MeasuredScene, AllRepeatsOfAMethodCount) {
    SceneState scene = threeLayers();
    scene.measurements[0].picks["aerial"] = {pair("aerial", 0.76), pair("aerial", 0.78)};
    scene.measurements[0].picks["front"] = {pair("front", 0.70), pair("front", 0.72), pair("front", 0.74)};
    const MeasuredScene measured = measureScene(scene);
    EXPECT_EQ(measured.lengths[0].length->repeats_m.size(), 5U);
    EXPECT_NEAR(measured.lengths[0].length->repeats_m[0], 0.76, 1e-12) << "in the order of the layers";
    EXPECT_NEAR(measured.lengths[0].length->mean_m, 0.74, 1e-12);
}

TEST(MeasuredScene, PairsAcrossLayersCarryTheRegistration) {
    SceneState scene = threeLayers();
    // The pose slides by 4 mm (1 sigma) along x and turns by 1 mrad about the z axis through (0, -3, 0).
    PoseUncertainty& pose = scene.layers[1].registration->quality->uncertainty;
    pose.covariance.setZero();
    pose.covariance(0, 0) = 0.004 * 0.004;
    pose.covariance(5, 5) = 1e-6;
    pose.pivot_m = {0, -3, 0};
    const PickedPair across{{"front", {0, 0, 0}, 0.0, false}, {"aerial", {4.9, 0, 0}, 0.0, false}};
    scene.measurements[0].picks["front"] = {across, across};
    const double ends = 0.0001 * 0.0001 + 0.03 * 0.03;
    const auto shareOf = [&] {
        const double u = *measureScene(scene).lengths[0].length->standardUncertainty_m;
        return std::sqrt(std::max(0.0, u * u - ends));
    };
    EXPECT_NEAR(shareOf(), 0.005, 1e-9) << "4 mm of the slide, 3 mm of the turn at 3 m from the pivot";
    EXPECT_EQ(measureScene(scene).lengths[0].layers, (std::vector<std::string>{"front", "aerial"}));
    const PickedPair upright{{"front", {0, 0, 0}, 0.0, false}, {"aerial", {0, 0, 2}, 0.0, false}};
    scene.measurements[0].picks["front"] = {upright, upright};
    EXPECT_NEAR(shareOf(), 0, 1e-6) << "neither moves the end along the length";
    const PickedPair within{{"front", {0, 0, 0}, 0.0, false}, {"front", {4.9, 0, 0}, 0.0, false}};
    scene.measurements[0].picks["front"] = {within, within};
    EXPECT_NEAR(*measureScene(scene).lengths[0].length->standardUncertainty_m, 0.0001 * std::sqrt(2), 1e-12)
        << "both ends move together";
}

TEST(MeasuredScene, BothPosesCountWhereBothEndsAreOfRegisteredLayers) {
    SceneState scene = threeLayers();
    scene.layers[2].registration = sampleResult(0.1, 0.2);
    for (const std::size_t i : {1, 2}) {
        PoseUncertainty& pose = scene.layers[i].registration->quality->uncertainty;
        pose.covariance.setZero();
        pose.covariance(0, 0) = i == 1 ? 9e-6 : 16e-6;
    }
    const PickedPair across{{"front", {0, 0, 0}, 0.0, false}, {"photo", {4.9, 0, 0}, 0.0, false}};
    scene.measurements[0].picks["front"] = {across, across};
    const double u = *measureScene(scene).lengths[0].length->standardUncertainty_m;
    EXPECT_NEAR(std::sqrt(u * u - 0.0001 * 0.0001 - 0.05 * 0.05), 0.005, 1e-9);
}

TEST(MeasuredScene, TheRmseStandsInForACovarianceThatIsMissing) {
    SceneState scene = threeLayers();
    scene.layers[1].registration->quality.reset();
    const PickedPair across{{"front", {0, 0, 0}, 0.0, false}, {"aerial", {4.9, 0, 0}, 0.0, false}};
    scene.measurements[0].picks["front"] = {across, across};
    const double u2 = 0.0001 * 0.0001 + 0.03 * 0.03 + 0.0123 * 0.0123;
    EXPECT_NEAR(*measureScene(scene).lengths[0].length->standardUncertainty_m, std::sqrt(u2), 1e-12);
}

TEST(MeasuredScene, PairsAcrossLayersWithoutACommonFrameAreNoLength) {
    SceneState scene = threeLayers();
    scene.measurements[0].picks["aerial"] = {
        {{"aerial", {0, 0, 0}, {}, false}, {"photo", {4.9, 0, 0}, {}, false}}};
    const MeasuredScene measured = measureScene(scene);
    EXPECT_FALSE(measured.lengths[0].length);
    EXPECT_NE(measured.lengths[0].note.find("not registered to each other"), std::string::npos);
}

TEST(MeasuredScene, LayersTheCaseLacksGiveANote) {
    SceneState scene = threeLayers();
    scene.measurements[0].picks["front"] = {pair("front", 0.75)};
    scene.layers.erase(scene.layers.begin() + 1);
    const MeasuredScene measured = measureScene(scene);
    ASSERT_EQ(measured.lengths.size(), 2U);
    for (const auto& row : measured.lengths) {
        EXPECT_FALSE(row.length);
        EXPECT_EQ(row.note,
                  "not measured with this method; picked on 'front', which this case does not have");
    }
}

TEST(MeasuredScene, ASpacingThatWasNotRecordedComesFromTheLoadedLayer) {
    SceneState scene = threeLayers();
    scene.layers[1].registration.reset();
    PointCloudBuilder builder;
    for (int x = 0; x < 40; ++x)
        for (int y = 0; y < 40; ++y) builder.add({10.0 * x, 10.0 * y, 0});  // millimetres
    LayerData data;
    const auto mesh = std::make_shared<const TriangleMesh>(TriangleMesh{std::move(builder).build(), {}});
    data.geometry = mesh;
    data.points = std::shared_ptr<const PointCloud>(mesh, &mesh->vertices);
    data.octree = std::make_shared<const Octree>(data.points);
    scene.layers[1].data = std::make_shared<const LayerData>(data);
    const PickedPair picked{{"front", {200, 200, 0}, {}, false}, {"front", {300, 200, 0}, 0.0, false}};
    scene.measurements[0].picks["front"] = {picked, picked};
    const double u = *measureScene(scene).lengths[0].length->standardUncertainty_m;
    const double spacing_m = std::sqrt(12 * (u * u - 2 * 0.0001 * 0.0001));
    EXPECT_NEAR(spacing_m, 0.01, 0.003);
}

TEST(MeasuredScene, ExclusionsStandInTheRows) {
    SceneState scene = threeLayers();
    scene.measurements.clear();
    for (int i = 0; i < 9; ++i) {
        Measurement object;
        object.object = "object " + std::to_string(i);
        object.tape_m = 1;
        object.picks["aerial"] = {pair("aerial", i == 4 ? 1.1 : 1 + (i % 2 == 0 ? 0.01 : -0.01))};
        scene.measurements.push_back(object);
    }
    scene.measurements[2].tape_m.reset();
    const MeasuredScene measured = measureScene(scene);
    EXPECT_EQ(measured.accuracy[0].n, 8U) << "an object without tape has no error";
    EXPECT_EQ(measured.accuracy[0].excluded, std::vector<std::string>{"object 4"});
    for (const auto& row : measured.lengths)
        EXPECT_EQ(row.excluded, row.method == "lidar" && row.object == "object 4") << row.object;
    EXPECT_EQ(measured.lengths[0].note, "one repeat only, so no uncertainty");
}
