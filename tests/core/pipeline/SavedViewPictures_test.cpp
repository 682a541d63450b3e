#include "core/pipeline/SavedViewPictures.h"

#include <gtest/gtest.h>

#include "core/geometry/CameraProjection.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/pipeline/DescribeView.h"
#include "core/pipeline/FrameView.h"
#include "core/pipeline/ScaledCamera.h"

using namespace vestige;

namespace {

/// A block of 4 x 2 x 1 m of points on a map grid, as the target of a case.
SceneState block() {
    PointCloudBuilder builder;
    for (int x = 0; x <= 40; ++x)
        for (int y = 0; y <= 20; ++y)
            for (int z = 0; z <= 10; ++z)
                builder.add(Eigen::Vector3d(483000 + 0.1 * x, 4375000 + 0.1 * y, 0.1 * z));
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->vertices = std::move(builder).build();
    auto data = std::make_shared<LayerData>();
    data->geometry = mesh;
    data->points = std::shared_ptr<const PointCloud>(mesh, &mesh->vertices);
    data->octree = std::make_shared<Octree>(data->points);
    SceneState scene;
    Layer layer;
    layer.id = layer.name = "aerial";
    layer.data = data;
    scene.layers.push_back(layer);
    scene.target = "aerial";
    return scene;
}

SavedView view(const std::string& name, NamedView from) {
    SavedView saved;
    saved.name = name;
    saved.camera = fitCamera({{483000, 4375000, 0}, {483004, 4375002, 1}}, from, 800, 600);
    return saved;
}

}  // namespace

TEST(SavedViewPictures, ShowWhatIsForTheReport) {
    SceneState scene = block();
    scene.savedViews = {view("Above", NamedView::top), view("Mine", NamedView::front),
                        view("Oblique", NamedView::perspective)};
    scene.savedViews[0].scale = 50;
    scene.savedViews[0].section = SectionBox{{483001, 4375001, 0.5}, {1, 1, 1}, 0};
    scene.savedViews[1].inReport = false;
    scene.savedViews[2].colorMode = "source";
    const auto pictures = savedViewPictures(scene, {});
    ASSERT_EQ(pictures.size(), 2U);
    EXPECT_EQ(pictures[0].file, "screenshots/view-01.png");
    EXPECT_EQ(pictures[0].caption, "Above, at 1:50 in print");
    EXPECT_TRUE(pictures[0].toScale);
    ASSERT_TRUE(pictures[0].view.section);
    EXPECT_TRUE(pictures[0].view.showNorthArrow) << "an aerial cloud on a map grid";
    // A metre of the scene takes 20 mm of the paper.
    const double metre_px = 1 / pictures[0].view.camera.metresPerPixel(1);
    EXPECT_NEAR(metre_px / *pictures[0].view.scale.dpi * 25.4, 20, 1e-9);
    EXPECT_FALSE(pictures[1].toScale);
    EXPECT_EQ(pictures[1].view.colorMode, ColorMode::source);
    EXPECT_EQ(pictures[1].view.camera.width_px, 1400);
    EXPECT_EQ(planPictures(scene, {}).size(), 2U + 2U) << "beside the overviews";
}

TEST(ScaledCamera, HoldsAllThereIsAtItsScale) {
    const SceneState scene = block();
    ViewDescription shown = describeView(scene, ColorMode::height, Overlay::none);
    for (const NamedView from : {NamedView::top, NamedView::front, NamedView::left, NamedView::iso}) {
        const ViewCamera camera =
            holdingAllAtScale(shown, frameView(shown, from, 1000, 1000), 20, 254);  // 0.5 px/mm
        EXPECT_TRUE(camera.parallel);
        EXPECT_NEAR(1 / camera.metresPerPixel(1), 500, 1e-9);
        const PointCloud& cloud = shown.layers[0].geometry->vertices;
        for (std::size_t i = 0; i < cloud.size(); ++i) {
            const Eigen::Vector2d pixel = camera.project(cloud.point(i))->pixel;
            ASSERT_TRUE(pixel.x() >= 0 && pixel.x() <= camera.width_px && pixel.y() >= 0 &&
                        pixel.y() <= camera.height_px)
                << name(from);
        }
    }
    const ViewCamera top = holdingAllAtScale(shown, frameView(shown, NamedView::top, 1000, 1000), 20, 254);
    EXPECT_NEAR(top.width_px, 4 * 500 + 200, 12) << "a centimetre on paper is left at either side";
    EXPECT_NEAR(top.height_px, 2 * 500 + 200, 12);
}

TEST(FrameView, ShowsTheSection) {
    const SceneState scene = block();
    ViewDescription shown = describeView(scene, ColorMode::height, Overlay::none);
    shown.section = SectionBox{{483001, 4375001, 0.5}, {0.5, 0.5, 0.5}, 0};
    const ViewCamera camera = frameView(shown, NamedView::top, 1000, 1000);
    EXPECT_NEAR(camera.focalPoint.x(), 483001, 0.06);
    EXPECT_LT(camera.halfHeight_m, 0.7);
    const ViewCamera again = framed(shown, withProjection(camera, false));
    EXPECT_NEAR(again.focalPoint.y(), 4375001, 0.06);
}
