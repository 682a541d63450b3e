#include "core/scene/MeasuredKinds.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Random.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/scene/CloudKinds.h"
#include "core/scene/MeasuredScene.h"
#include "tests/core/scene/SampleScene.h"

using namespace vestige;
using vestige::test::sampleLayer;
using vestige::test::sampleResult;

namespace {

PickedPoint at(const std::string& layer, double x, double y, double z) {
    return {layer, {x, y, z}, 0.0, false};
}

SceneState twoLayers() {
    SceneState scene;
    scene.layers = {sampleLayer("aerial", LayerRole::aerial), sampleLayer("front", LayerRole::handheld)};
    for (Layer& layer : scene.layers) layer.data = nullptr;
    scene.layers[1].registration = sampleResult(0.1, 0.2);
    scene.target = "aerial";
    return scene;
}

Measurement object(const std::string& name, MeasurementKind kind) {
    Measurement measurement;
    measurement.object = name;
    measurement.kind = kind;
    return measurement;
}

std::shared_ptr<const LayerData> flatGround() {
    Random random(3);
    PointCloudBuilder builder;
    for (int i = 0; i < 40'000; ++i)
        builder.add({random.uniform(-5, 5), random.uniform(-5, 5), random.normal(0.4, 0.005)});
    auto data = std::make_shared<LayerData>();
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->vertices = std::move(builder).build();
    data->points = std::shared_ptr<const PointCloud>(mesh, &mesh->vertices);
    data->octree = std::make_shared<const Octree>(data->points);
    data->geometry = mesh;
    return data;
}

}  // namespace

TEST(MeasuredKinds, EveryDistanceHasItsPartsAndABudgetThatAgreesWithItsRow) {
    SceneState scene = twoLayers();
    Measurement box = object("Box", MeasurementKind::distance);
    for (const double length : {1.0, 1.02, 0.99})
        box.picks["aerial"].push_back({at("aerial", 0, 0, 0), at("front", 0.6 * length, 0, 0.8 * length)});
    scene.measurements = {box};
    const MeasuredScene measured = measureScene(scene);
    ASSERT_EQ(measured.kinds.size(), 1U);
    ASSERT_EQ(measured.lengths.size(), 1U);
    const QuantityStatistic* distance = measured.kinds[0].find("distance");
    ASSERT_NE(distance, nullptr);
    EXPECT_NEAR(distance->mean, measured.lengths[0].length->mean_m, 1e-12);
    EXPECT_NEAR(*distance->standardUncertainty, *measured.lengths[0].length->standardUncertainty_m, 1e-5);
    EXPECT_NEAR(measured.kinds[0].find("horizontal")->mean, 0.6 * 3.01 / 3, 1e-12);
    EXPECT_EQ(distance->budget.contributions.back().source, "registration of Layer front");
}

TEST(MeasuredKinds, LengthsOfOtherKindsAreRowsAndCountInTheAccuracy) {
    SceneState scene = twoLayers();
    Measurement skid = object("Skid mark", MeasurementKind::polyline);
    skid.tape_m = 5;
    skid.paths["aerial"] = {{at("aerial", 0, 0, 0), at("aerial", 2, 0, 0), at("aerial", 5.1, 0, 0)}};
    Measurement turn = object("Turn", MeasurementKind::angle);
    turn.settings["reference_deg"] = 80;
    turn.paths["aerial"] = {{at("aerial", 1, 0, 0), at("aerial", 0, 0, 0), at("aerial", 0, 1, 0)}};
    Measurement height = object("Height", MeasurementKind::vertical);
    height.picks["aerial"] = {{at("aerial", 0, 0, 0), at("aerial", 1, 1, 1.5)}};
    scene.measurements = {skid, turn, height};
    const MeasuredScene measured = measureScene(scene);
    ASSERT_EQ(measured.lengths.size(), 2U) << "an angle is no length";
    EXPECT_NEAR(measured.lengths[0].length->mean_m, 5.1, 1e-12);
    EXPECT_NEAR(*measured.lengths[0].re, 0.02, 1e-12);
    EXPECT_NEAR(measured.lengths[1].length->mean_m, 1.5, 1e-12);
    EXPECT_EQ(measured.accuracy[0].n, 1U);
    EXPECT_NEAR(*measured.accuracy[0].rmseAll, 0.02, 1e-12);
    ASSERT_EQ(measured.kinds.size(), 3U);
    EXPECT_NEAR(*measured.kinds[1].quantities.front().relativeError, 0.125, 1e-12);
    EXPECT_EQ(measured.kinds[1].note, "one repeat only, so no uncertainty");
}

TEST(MeasuredKinds, TellsWhatItLeavesOut) {
    SceneState scene = twoLayers();
    scene.layers[1].registration.reset();
    Measurement turn = object("Turn", MeasurementKind::angle);
    turn.paths["aerial"] = {{at("aerial", 1, 0, 0), at("aerial", 0, 0, 0)},
                            {at("aerial", 1, 0, 0), at("gone", 0, 0, 0), at("aerial", 0, 1, 0)},
                            {at("aerial", 1, 0, 0), at("front", 0, 0, 0), at("aerial", 0, 1, 0)}};
    scene.measurements = {turn};
    const MeasuredScene measured = measureScene(scene);
    EXPECT_TRUE(measured.kinds[0].quantities.empty());
    EXPECT_NE(measured.kinds[0].note.find("1 repeat left out: this kind needs 3 points"), std::string::npos)
        << measured.kinds[0].note;
    EXPECT_NE(measured.kinds[0].note.find("which this case does not have"), std::string::npos);
    EXPECT_NE(measured.kinds[0].note.find("not registered to each other"), std::string::npos);
}

TEST(MeasuredKinds, FittedFeaturesStandBesideThePicks) {
    SceneState scene = twoLayers();
    Measurement skid = object("Skid mark", MeasurementKind::polyline);
    PickedPoint end = at("aerial", 5.1, 0, 0);
    end.fitted = FittedFeature{};
    end.fitted->position = {5, 0, 0};
    end.fitted->covariance = Eigen::Matrix3d::Identity() * 1e-6;
    skid.paths["aerial"] = {{at("aerial", 0, 0, 0), end}, {at("aerial", 0, 0, 0), end}};
    scene.measurements = {skid};
    const MeasuredScene measured = measureScene(scene);
    ASSERT_EQ(measured.kinds.size(), 2U);
    EXPECT_EQ(measured.kinds[0].method, "lidar");
    EXPECT_NEAR(measured.kinds[0].quantities.front().mean, 5.1, 1e-12);
    EXPECT_EQ(measured.kinds[1].method, "lidar fitted");
    EXPECT_NEAR(measured.kinds[1].quantities.front().mean, 5, 1e-12);
    EXPECT_LT(measured.kinds[1].quantities.front().budget.standard,
              measured.kinds[0].quantities.front().budget.standard);
}

TEST(MeasuredKinds, VolumeAndSectionLookAtTheLoadedCloud) {
    SceneState scene = twoLayers();
    scene.layers[0].data = flatGround();
    Measurement heap = object("Heap", MeasurementKind::volume);
    heap.paths["aerial"] = {
        {at("aerial", -1, -1, 0), at("aerial", 1, -1, 0), at("aerial", 1, 1, 0), at("aerial", -1, 1, 0)}};
    Measurement section = object("Section", MeasurementKind::profile);
    section.picks["aerial"] = {{at("aerial", -2, 0, 0.4), at("aerial", 2, 0, 0.4)}};
    scene.measurements = {heap, section};
    const MeasuredScene measured = measureScene(scene);
    ASSERT_FALSE(measured.kinds[0].quantities.empty()) << measured.kinds[0].note;
    EXPECT_NEAR(measured.kinds[0].quantities.front().mean, 1.6, 0.003);
    ASSERT_NE(measured.kinds[1].find("highest"), nullptr) << measured.kinds[1].note;
    EXPECT_NEAR(measured.kinds[1].find("rise")->mean, 0, 0.01);
    EXPECT_EQ(measured.kinds[1].series.size(), 1U);
    const MeasuredScene again = measureScene(scene);
    EXPECT_EQ(again.kinds[0].quantities.front().mean, measured.kinds[0].quantities.front().mean);
}

TEST(MeasuredKinds, CrushAgainstTheOutlineOfAnotherScan) {
    SceneState scene = twoLayers();
    Measurement front = object("Front", MeasurementKind::crush);
    front.settings["outline_points"] = 3;
    PickedPath path{at("aerial", 0, 0, 0.5), at("aerial", 1.8, 0, 0.5), at("aerial", 0, 0.2, 0.5),
                    at("aerial", 0.9, 0.4, 0.5), at("aerial", 1.8, 0.2, 0.5)};
    // A whole vehicle of the same make, 6 m away on a scan of its own, bulging by 0.1 m to its front.
    for (const auto& [x, y] : {std::pair(0.0, 6.0), {0.9, 5.9}, {1.8, 6.0}})
        path.push_back(at("front", x, y, 0.5));
    front.paths["aerial"] = {path, path};
    scene.measurements = {front};
    const MeasuredScene measured = measureScene(scene);
    ASSERT_FALSE(measured.kinds[0].quantities.empty()) << measured.kinds[0].note;
    EXPECT_NEAR(measured.kinds[0].find("c1")->mean, 0.2, 1e-9);
    // At 0.72 m the damage is 0.36 m deep, and the whole outline 0.08 m out.
    EXPECT_NEAR(measured.kinds[0].find("c3")->mean, 0.44, 1e-9);
    const auto& lines = measured.kinds[0].find("c3")->budget.contributions;
    EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [](const Contribution& line) {
        return line.source == "registration of Layer front" && line.part() > 0;
    }));
}

TEST(MeasuredKinds, CloudsAreAskedLaterWhereThatIsWanted) {
    SceneState scene = twoLayers();
    scene.layers[0].data = flatGround();
    Measurement heap = object("Heap", MeasurementKind::volume);
    heap.paths["aerial"] = {
        {at("aerial", -1.5, -1, 0), at("aerial", 1, -1, 0), at("aerial", 1, 1, 0), at("aerial", -1, 1, 0)}};
    Measurement box = object("Box", MeasurementKind::distance);
    box.picks["aerial"] = {{at("aerial", 0, 0, 0), at("aerial", 1, 0, 0)}};
    scene.measurements = {heap, box};
    std::vector<KindRepeats> missing;
    {
        const CloudKindsLater later;
        const MeasuredScene first = measureScene(scene);
        EXPECT_TRUE(first.kinds[0].quantities.empty());
        EXPECT_EQ(first.kinds[0].note, "being computed from the cloud");
        EXPECT_FALSE(first.kinds[1].quantities.empty()) << "what asks no cloud is found at once";
        missing = later.missing();
        ASSERT_EQ(missing.size(), 1U);
    }
    const JobControl stopped;
    stopped.cancel();
    const Status none = computeCloudKinds(scene, missing, stopped);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::cancelled);
    ASSERT_TRUE(computeCloudKinds(scene, missing, {}));
    const CloudKindsLater later;
    const MeasuredScene second = measureScene(scene);
    EXPECT_TRUE(later.missing().empty());
    ASSERT_FALSE(second.kinds[0].quantities.empty());
    // 4.5 m2 of ground 0.4 m over the plane of the corners.
    EXPECT_NEAR(second.kinds[0].quantities.front().mean, 0.4 * 4.5, 0.01);
}

TEST(MeasuredKinds, VolumeBetweenTwoScans) {
    SceneState scene = twoLayers();
    scene.layers[0].data = flatGround();
    // The same ground 0.1 m deeper as a registered scan of its own, in metres.
    scene.layers[1].data = flatGround();
    scene.layers[1].unit = LengthUnit::metre;
    scene.layers[1].registration = sampleResult(0, 0);
    scene.layers[1].registration->targetFromSource.scale = 1;
    scene.layers[1].registration->targetFromSource.pose.translation().z() = -0.1;
    Measurement heap = object("Heap", MeasurementKind::volume);
    heap.settings["base_scan"] = 2;
    heap.paths["aerial"] = {
        {at("aerial", -1, -1, 0), at("aerial", 1, -1, 0), at("aerial", 1, 1, 0), at("aerial", -1, 1, 0)}};
    scene.measurements = {heap};
    const MeasuredScene measured = measureScene(scene);
    ASSERT_FALSE(measured.kinds[0].quantities.empty()) << measured.kinds[0].note;
    const QuantityStatistic& volume = measured.kinds[0].quantities.front();
    EXPECT_NEAR(volume.mean, 0.4, 0.003);
    double ofBase = 0;
    for (const Contribution& each : volume.budget.contributions)
        if (each.source == "height of the base") ofBase = each.part();
    const Eigen::Matrix3d pose = scene.layers[1].registration->quality->uncertainty.at({-1, -1, 0});
    EXPECT_NEAR(ofBase, 4 * std::sqrt(pose(2, 2)), 1e-9);
    scene.measurements[0].settings["base_scan"] = 3;
    EXPECT_TRUE(measureScene(scene).kinds[0].quantities.empty());
}

TEST(DistanceChecks, VerifiedOnlyWhereAKnownDistanceAgrees) {
    SceneState scene = twoLayers();
    Measurement bar = object("Scale bar", MeasurementKind::distance);
    bar.tape_m = 2;
    bar.tapeResolution_m = 0.001;
    for (const double length : {2.004, 2.006, 2.005})
        bar.picks["aerial"].push_back({at("aerial", 0, 0, 0), at("aerial", length, 0, 0)});
    Measurement car = object("Car", MeasurementKind::distance);
    car.picks["aerial"] = bar.picks["aerial"];
    scene.measurements = {bar, car};
    EXPECT_EQ(verification(measureScene(scene)), Verification::notChecked) << "no object is a check yet";

    scene.measurements[0].checkTolerance_m = 0.01;
    const MeasuredScene good = measureScene(scene);
    ASSERT_EQ(good.checks.size(), 1U);
    EXPECT_EQ(good.checks[0].verdict, DistanceCheck::Verdict::passed);
    EXPECT_NEAR(*good.checks[0].difference_m, 0.005, 1e-12);
    EXPECT_NE(good.checks[0].note.find("larger than the tolerance"), std::string::npos);
    EXPECT_EQ(verification(good), Verification::verified);

    scene.measurements[0].checkTolerance_m = 0.004;
    const MeasuredScene bad = measureScene(scene);
    EXPECT_EQ(bad.checks[0].verdict, DistanceCheck::Verdict::failed);
    EXPECT_EQ(verification(bad), Verification::failed);

    scene.measurements[0].picks.clear();
    const MeasuredScene open = measureScene(scene);
    EXPECT_EQ(open.checks[0].verdict, DistanceCheck::Verdict::notMeasured);
    EXPECT_EQ(verification(open), Verification::notChecked);
    scene.measurements[0].tape_m.reset();
    EXPECT_TRUE(measureScene(scene).checks.empty()) << "nothing is known without the tape";
}

TEST(DistanceChecks, EveryMethodThatMeasuredNeedsItsOwn) {
    SceneState scene = twoLayers();
    scene.layers.push_back(sampleLayer("photo", LayerRole::photogrammetry));
    scene.layers[2].data = nullptr;
    scene.layers[2].registration = sampleResult(0, 0);
    Measurement bar = object("Scale bar", MeasurementKind::distance);
    bar.tape_m = 2;
    bar.checkTolerance_m = 0.01;
    bar.picks["aerial"] = {{at("aerial", 0, 0, 0), at("aerial", 2, 0, 0)}};
    Measurement car = object("Car", MeasurementKind::distance);
    car.picks["photo"] = {{at("photo", 0, 0, 0), at("photo", 4, 0, 0)}};
    scene.measurements = {bar, car};
    const MeasuredScene measured = measureScene(scene);
    EXPECT_EQ(verification(measured.checks, "lidar"), Verification::verified);
    EXPECT_EQ(verification(measured.checks, "photogrammetry"), Verification::notChecked);
    EXPECT_EQ(verification(measured), Verification::notChecked);
}
