#include "core/pipeline/CloseUp.h"

#include <gtest/gtest.h>

#include "core/geometry/Octree.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/pipeline/DescribeView.h"

using namespace vestige;

namespace {

const Eigen::Vector3d kOrigin{518000, 4326000, 3};

/// A road of 10 x 10 m with a crown of the same extent 4 m above it.
SceneState roadUnderCrown() {
    PointCloudBuilder builder;
    for (const double z : {0.0, 4.0})
        for (int y = 0; y <= 100; ++y)
            for (int x = 0; x <= 100; ++x) builder.add(kOrigin + Eigen::Vector3d(0.1 * x, 0.1 * y, z));
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->vertices = std::move(builder).build();
    auto data = std::make_shared<LayerData>();
    data->geometry = mesh;
    data->points = std::shared_ptr<const PointCloud>(mesh, &mesh->vertices);
    data->octree = std::make_shared<const Octree>(data->points);
    SceneState scene;
    Layer layer;
    layer.id = layer.name = "aerial";
    layer.unit = LengthUnit::metre;
    layer.data = data;
    scene.layers.push_back(layer);
    scene.target = "aerial";
    return scene;
}

const ViewMark kMark{kOrigin + Eigen::Vector3d(4.5, 5, 0), kOrigin + Eigen::Vector3d(5.5, 5, 0), "1 m",
                     false};

MeasuredLength length() {
    MeasuredLength length;
    length.object = "Line";
    length.method = "lidar";
    length.layers = {"aerial"};
    return length;
}

}  // namespace

TEST(CloseUp, LeavesOutWhatHangsAboveAndSaysSo) {
    const SceneState scene = roadUnderCrown();
    ViewDescription view = describeView(scene, ColorMode::source, Overlay::none);
    const Eigen::Vector3d middle = 0.5 * (kMark.a + kMark.b);
    EXPECT_TRUE(cropView(view, scene, middle, 6, middle.z() + 1));
    ASSERT_EQ(view.layers.size(), 1u);
    const BoundingBox box = bounds(view);
    EXPECT_NEAR(box.max.z(), kOrigin.z(), 1e-4);
    EXPECT_NEAR(box.min.x(), kOrigin.x(), 1e-4) << "what is below stays, out to the radius";

    ViewDescription near = describeView(scene, ColorMode::source, Overlay::none);
    EXPECT_FALSE(cropView(near, scene, middle, 2, middle.z() + 1)) << "no crown is as near as that";
    EXPECT_NEAR(bounds(near).max.x(), middle.x() + 2, 0.11);
}

TEST(CloseUp, LooksFromWhereBothEndsAreSeenBelowTheCeiling) {
    const SceneState scene = roadUnderCrown();
    ViewDescription view = describeView(scene, ColorMode::source, Overlay::none);
    cropView(view, scene, 0.5 * (kMark.a + kMark.b), 6, kOrigin.z() + 1);
    const Eigen::Vector3d direction = closeUpDirection(view, scene, length(), kMark);
    EXPECT_LT(direction.z(), -0.3) << "down onto the road";
    EXPECT_LT(std::abs(direction.dot((kMark.b - kMark.a).normalized())), 0.1) << "square to the pair";
}

TEST(CloseUp, LooksFromWhereMostOfAPathIsSeen) {
    const SceneState scene = roadUnderCrown();
    ViewDescription view = describeView(scene, ColorMode::source, Overlay::none);
    std::vector<Eigen::Vector3d> path;
    for (int i = 0; i < 40; ++i) path.push_back(kOrigin + Eigen::Vector3d(2 + 0.1 * i, 5, 0));
    const CloseUpSphere sphere = sphereRound(path);
    EXPECT_NEAR(sphere.centre.x(), kOrigin.x() + 3.95, 1e-9);
    for (const Eigen::Vector3d& point : path) EXPECT_LT((point - sphere.centre).norm(), sphere.radius_m);
    // Under the crown nothing of it is seen from above; with the crown left out it is from steeply above.
    cropView(view, scene, sphere.centre, 4 * sphere.radius_m, kOrigin.z() + 1);
    const Eigen::Vector3d direction = closeUpDirection(view, {"aerial"}, path).normalized();
    EXPECT_LT(direction.z(), -0.6) << "a mark on the ground is looked at from higher up";
    EXPECT_LT(std::abs(direction.x()), 0.1) << "square to the path";
}
