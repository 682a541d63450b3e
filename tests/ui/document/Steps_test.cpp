#include "ui/document/Steps.h"

#include <gtest/gtest.h>

#include "core/scene/Cleaning.h"

namespace vestige {
namespace {

std::shared_ptr<LayerData> read(std::uint64_t awaited = 0) {
    auto geometry = std::make_shared<TriangleMesh>();
    auto data = std::make_shared<LayerData>();
    data->geometry = geometry;
    data->points = std::shared_ptr<const PointCloud>(geometry, &geometry->vertices);
    data->awaitedPoints = awaited;
    return data;
}

Layer layer(const std::string& id, LayerRole role) {
    Layer made;
    made.id = id;
    made.name = id;
    made.role = role;
    made.data = read();
    return made;
}

Measurement measured(const std::string& object, std::size_t repeats, std::optional<double> tape_m) {
    Measurement made;
    made.object = object;
    made.tape_m = tape_m;
    made.picks["aerial"].resize(repeats,
                                {{"aerial", {0, 0, 0}, {}, false}, {"aerial", {1, 0, 0}, {}, false}});
    return made;
}

SceneState twoScans() {
    SceneState scene;
    scene.layers = {layer("aerial", LayerRole::aerial), layer("front", LayerRole::handheld)};
    scene.target = "aerial";
    return scene;
}

StepFacts factsOf(const SceneState& scene, WayStep step, bool reported = false) {
    return stepsOf(scene, measureScene(scene), reported)[static_cast<std::size_t>(step)];
}

TEST(Steps, AnEmptyCaseBeginsWithItsScans) {
    const SceneState scene;
    const auto steps = stepsOf(scene, measureScene(scene), false);
    EXPECT_EQ(steps[0].missing, QStringList{"no scans yet"});
    EXPECT_EQ(nextStep(steps), WayStep::import);
    for (std::size_t i = 1; i < steps.size(); ++i) {
        EXPECT_EQ(steps[i].state, StepState::waiting) << i;
        EXPECT_TRUE(steps[i].missing.isEmpty()) << "nobody is told of what comes later";
        EXPECT_FALSE(steps[i].summary.isEmpty());
    }
}

TEST(Steps, WhatIsNotReadIsNamed) {
    SceneState scene = twoScans();
    EXPECT_EQ(factsOf(scene, WayStep::import).state, StepState::done);
    scene.layers[1].data = nullptr;
    EXPECT_EQ(factsOf(scene, WayStep::import).missing, QStringList{"front was not read"});
    scene.layers[0].data = read(1'000'000);
    EXPECT_EQ(factsOf(scene, WayStep::import).missing,
              (QStringList{"front was not read", "aerial is still being read"}));
}

TEST(Steps, AScanThatIsNotRegisteredIsNamed) {
    SceneState scene = twoScans();
    EXPECT_EQ(factsOf(scene, WayStep::align).missing, QStringList{"front is not registered"});
    EXPECT_EQ(nextStep(stepsOf(scene, measureScene(scene), false)), WayStep::align);
    scene.layers.push_back(layer("rear", LayerRole::handheld));
    EXPECT_EQ(factsOf(scene, WayStep::align).missing, QStringList{"2 scans are not registered"});
    scene.layers.pop_back();
    scene.layers[1].registration = RegistrationResult();
    scene.layers[1].registration->verdict = Verdict::doubtful;
    EXPECT_EQ(factsOf(scene, WayStep::align).missing, QStringList{"the fit of front is doubtful"});
    scene.layers[1].registration->verdict = Verdict::accepted;
    EXPECT_EQ(factsOf(scene, WayStep::align).state, StepState::done);
    scene.layers.push_back(layer("photo", LayerRole::photogrammetry));
    EXPECT_EQ(factsOf(scene, WayStep::align).state, StepState::done) << "it is compared as it comes";
    scene.layers.resize(1);
    EXPECT_EQ(factsOf(scene, WayStep::align).state, StepState::done)
        << "one scan has nothing to be aligned with";
}

TEST(Steps, CleaningIsOptional) {
    SceneState scene = twoScans();
    EXPECT_EQ(factsOf(scene, WayStep::clean).state, StepState::optional);
    scene.layers[0].cleaning = std::make_shared<const Cleaning>();
    EXPECT_EQ(factsOf(scene, WayStep::clean).state, StepState::done);
}

TEST(Steps, RepeatsAndAimsThatAreMissingAreNamed) {
    SceneState scene = twoScans();
    EXPECT_EQ(factsOf(scene, WayStep::measure).missing, QStringList{"nothing is measured yet"});
    scene.measurements = {measured("Length", 3, 4.93), measured("Width", 2, 1.8)};
    EXPECT_EQ(factsOf(scene, WayStep::measure).missing, QStringList{"Width has fewer than 3 repeats"});
    scene.measurements.push_back(measured("Mirror", 0, 0.2));
    scene.measurements.push_back(measured("Wheel", 0, 0.6));
    scene.measurements.back().aims["lidar"].resize(3);
    EXPECT_EQ(factsOf(scene, WayStep::measure).missing,
              (QStringList{"Wheel has recorded aims to take", "Mirror is not measured",
                           "Width has fewer than 3 repeats"}));
    scene.measurements.resize(1);
    EXPECT_EQ(factsOf(scene, WayStep::measure).state, StepState::done);
    Measurement skid;
    skid.object = "Skid mark";
    skid.paths["aerial"].resize(3);
    scene.measurements.push_back(skid);
    EXPECT_EQ(factsOf(scene, WayStep::measure).state, StepState::done) << "paths are repeats, too";
}

TEST(Steps, TheReportNeedsTapesAndAnOperator) {
    SceneState scene = twoScans();
    scene.layers[1].registration = RegistrationResult();
    scene.layers[1].registration->verdict = Verdict::accepted;
    scene.measurements = {measured("Length", 3, {}), measured("Width", 3, {}), measured("Mirror", 3, 0.2)};
    EXPECT_EQ(factsOf(scene, WayStep::report).missing,
              (QStringList{"2 objects without a tape value", "no operator is named", "not written yet"}));
    scene.measurements.resize(1);
    Measurement patch;
    patch.object = "Patch";
    patch.kind = MeasurementKind::area;
    patch.paths["aerial"].resize(3);
    scene.measurements.push_back(patch);  // no tape measures an area
    scene.operatorName = "A. Analyst";
    EXPECT_EQ(factsOf(scene, WayStep::report).missing,
              (QStringList{"Length has no tape value", "not written yet"}));
    scene.measurements[0].tape_m = 4.93;
    EXPECT_EQ(nextStep(stepsOf(scene, measureScene(scene), false)), WayStep::report);
    EXPECT_EQ(factsOf(scene, WayStep::report, true).state, StepState::done);
    EXPECT_TRUE(factsOf(scene, WayStep::report, true).missing.isEmpty());
}

}  // namespace
}  // namespace vestige
