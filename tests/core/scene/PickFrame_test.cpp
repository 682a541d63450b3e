#include "core/scene/PickFrame.h"

#include <gtest/gtest.h>

#include "core/scene/edits/Same.h"
#include "tests/core/scene/SampleScene.h"

using namespace vestige;
using vestige::test::sampleScene;

TEST(PickFrame, PositionsOfTargetAndRegisteredLayersAreInTheScene) {
    const SceneState scene = sampleScene();
    for (const char* layer : {"aerial", "front"})
        EXPECT_EQ(scenePosition(scene, {layer, {1, 2, 3}, {}, false}), Eigen::Vector3d(1, 2, 3));
    EXPECT_TRUE(inTargetFrame(scene, {"front", {1, 2, 3}, {}, false}));
}

TEST(PickFrame, OtherLayersKeepTheirFrameAndUnit) {
    SceneState scene = sampleScene();
    scene.layers[1].registration.reset();
    scene.layers[1].init = InitIdentity{};
    EXPECT_TRUE(scenePosition(scene, {"front", {1000, 0, 0}, {}, false}).isApprox(Eigen::Vector3d(1, 0, 0)));
    EXPECT_FALSE(inTargetFrame(scene, {"front", {1, 2, 3}, {}, false}));
    // With a first pose given, the case means the place that the layer will have.
    scene.layers[1].init = InitPicks{"/data/front_picks.csv"};
    EXPECT_EQ(scenePosition(scene, {"front", {1, 0, 0}, {}, false}), Eigen::Vector3d(1, 0, 0));
    EXPECT_TRUE(scenePosition(scene, {"front", {1000, 0, 0}, {}, true}).isApprox(Eigen::Vector3d(1, 0, 0)));
}

TEST(PickFrame, PickAtComesBackToItsPlace) {
    const SceneState scene = sampleScene();
    const Eigen::Vector3d world(3, 4, 5);
    for (const char* layer : {"aerial", "front", "photo"}) {
        const PickedPoint point = pickAt(scene, layer, world, 0.01);
        EXPECT_LT((scenePosition(scene, point) - world).norm(), 1e-12);
        EXPECT_EQ(point.inLayerFrame, std::string(layer) == "photo");
    }
}

TEST(PickFrame, CamerasBoundToALayerMoveAlong) {
    SceneState scene = sampleScene();
    const Similarity toScene = sceneFromLayer(scene.layers[1]);
    const auto camera = cameraInScene(scene, "side");
    ASSERT_TRUE(camera);
    EXPECT_LT((camera->position - toScene * Eigen::Vector3d(10, 0, 2.5)).norm(), 1e-12);
    EXPECT_NEAR(camera->viewUp.norm(), 1, 1e-12);
    EXPECT_TRUE(same(*cameraInScene(scene, "top"), scene.views.at("top")));
    EXPECT_FALSE(cameraInScene(scene, "absent"));
    scene.layers.erase(scene.layers.begin() + 1);
    EXPECT_FALSE(cameraInScene(scene, "side"));
}
