#include "core/pipeline/ViewRenderer.h"

#include <gtest/gtest.h>
#include "core/geometry/PointCloudBuilder.h"

namespace vestige {
namespace {

TEST(ViewNames, ReadBackAsWhatTheyName) {
    for (const auto mode : {ColorMode::height, ColorMode::intensity, ColorMode::rgb, ColorMode::source})
        EXPECT_EQ(colorModeFromName(name(mode)), mode);
    for (const auto overlay : {Overlay::none, Overlay::registration, Overlay::residual, Overlay::source})
        EXPECT_EQ(overlayFromName(name(overlay)), overlay);
    EXPECT_FALSE(colorModeFromName("colour"));
    EXPECT_FALSE(overlayFromName(""));
}

TEST(ViewBounds, HoldTheVisibleLayersInWorldMetres) {
    PointCloudBuilder builder;
    builder.add({0, 0, 0});
    builder.add({1000, 2000, 3000});
    const auto geometry = std::make_shared<const TriangleMesh>(TriangleMesh{std::move(builder).build(), {}});
    ViewDescription view;
    ViewLayer layer;
    layer.geometry = geometry;
    layer.worldFromLayer.scale = 0.001;
    view.layers.push_back(layer);
    layer.worldFromLayer.pose.translation() = Eigen::Vector3d(100, 0, 0);
    layer.visible = false;
    view.layers.push_back(layer);
    EXPECT_TRUE(bounds(view).max.isApprox(Eigen::Vector3d(1, 2, 3), 1e-6));
    EXPECT_TRUE(bounds(view).min.isZero(1e-9));
}

}  // namespace
}  // namespace vestige
