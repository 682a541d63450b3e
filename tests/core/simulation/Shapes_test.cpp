#include "core/simulation/shapes/Shapes.h"

#include <gtest/gtest.h>

#include "core/simulation/SceneModel.h"

namespace vestige {
namespace {

double trueLength(const SceneModel& scene, const MeasurementSpec& measurement) {
    return (scene.surfaces.feature(measurement.from)->position -
            scene.surfaces.feature(measurement.to)->position)
        .norm();
}

TEST(Shapes, FeaturesHaveTheTapedLengths) {
    for (const SceneSpec& spec : {twoCarsScene(), bicycleScene()}) {
        const auto scene = buildScene(spec, 1);
        ASSERT_TRUE(scene) << scene.error().sentence();
        EXPECT_GE(spec.measurements.size(), 11U);
        for (const MeasurementSpec& measurement : spec.measurements)
            EXPECT_NEAR(trueLength(*scene, measurement), measurement.tape_m, 1e-9) << measurement.object;
    }
}

SurfaceModel car(double length, double width) {
    ParameterSet parameters(shapeKind("car")->parameters());
    EXPECT_TRUE(parameters.set("length_m", length));
    EXPECT_TRUE(parameters.set("width_m", width));
    Random random(1);
    return shapeKind("car")->build(parameters, random);
}

TEST(Shapes, CarSurfacesHaveTheTapedSizes) {
    const SurfaceModel model = car(4.93, 1.84);
    const BoundingBox whole = model.boundsOf({});
    EXPECT_NEAR(whole.extent().x(), 4.93, 1e-9);
    EXPECT_NEAR(whole.min.z(), 0, 1e-9) << "it stands on its wheels";
    EXPECT_NEAR(whole.max.z(), 1.46, 0.01);
    const BoundingBox body =
        model.boundsOf({"left side", "right side", "front", "rear", "bonnet", "boot", "belt", "roof"});
    EXPECT_NEAR(body.extent().y(), 1.84, 1e-9) << "width without mirrors";
    EXPECT_GT(whole.extent().y(), 2.0) << "mirrors stand out";
    EXPECT_NEAR(model.boundsOf({"right mirror"}).extent().y(), 0.21, 1e-9);
    EXPECT_NEAR(model.boundsOf({"right handle"}).extent().x(), 0.26, 1e-9);
    EXPECT_NEAR(model.boundsOf({"tyre rear left"}).extent().x(), 0.65, 1e-9);
    EXPECT_NEAR(model.boundsOf({"tyre rear left"}).extent().z(), 0.65, 1e-9);
}

TEST(Shapes, BicycleHasItsTapedSizes) {
    Random random(1);
    const SurfaceModel bicycle =
        shapeKind("bicycle")->build(ParameterSet(shapeKind("bicycle")->parameters()), random);
    EXPECT_NEAR(bicycle.boundsOf({"front_wheel", "rear_wheel"}).extent().x(), 1.58, 1e-9);
    EXPECT_NEAR(bicycle.boundsOf({"rear_wheel"}).extent().x(), 0.56, 1e-9);
    EXPECT_NEAR(bicycle.boundsOf({"rear_wheel"}).extent().z(), 0.56, 1e-9);
}

/// Every feature lies on a surface of its own part, or an aim at it would miss.
TEST(Shapes, FeaturesLieOnTheirParts) {
    for (const SceneSpec& spec : {twoCarsScene(), bicycleScene()}) {
        const auto scene = buildScene(spec, 1);
        ASSERT_TRUE(scene);
        const SurfaceModel& surfaces = scene->surfaces;
        for (const MeasurementSpec& measurement : spec.measurements) {
            for (const std::string& name : {measurement.from, measurement.to}) {
                const FeaturePoint& feature = *surfaces.feature(name);
                BoundingBox box = surfaces.boundsOf({surfaces.parts[feature.part]});
                const Eigen::Array3d room = 1e-6 + Eigen::Array3d::Zero();
                EXPECT_TRUE((feature.position.array() >= box.min.array() - room).all()) << name;
                EXPECT_TRUE((feature.position.array() <= box.max.array() + room).all()) << name;
                bool near = false;
                for (const Face& face : surfaces.faces) {
                    if (face.part != feature.part) continue;
                    const Eigen::Vector3d a = surfaces.vertices[face.corners[0]];
                    const Eigen::Vector3d normal = (surfaces.vertices[face.corners[1]] - a)
                                                       .cross(surfaces.vertices[face.corners[2]] - a);
                    const double height = normal.normalized().dot(feature.position - a);
                    const Eigen::Vector3d middle =
                        (a + surfaces.vertices[face.corners[1]] + surfaces.vertices[face.corners[2]]) / 3;
                    near = near || (std::abs(height) < 1e-6 && (middle - feature.position).norm() < 0.6);
                }
                EXPECT_TRUE(near) << name;
            }
        }
    }
}

}  // namespace
}  // namespace vestige
