#include <gtest/gtest.h>

#include "core/geometry/PointCloudBuilder.h"
#include "tests/ui/view/Samples.h"
#include "ui/view/PointColors.h"

using namespace vestige;
using namespace vestige::test;

namespace {

double luminance(const Rgb& color) {
    return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
}

/// Three points at 0, 1 and 2 m with intensity and colour.
ViewDescription threePoints(ColorMode mode) {
    PointCloudBuilder builder;
    for (int i = 0; i < 3; ++i) builder.add({0, 0, static_cast<double>(i)});
    builder.attributes().intensity = {10, 200, 4000};
    builder.attributes().color = {Color{65535, 0, 0}, Color{0, 128 * 257, 0}, Color{0, 0, 257}};
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->vertices = std::move(builder).build();
    ViewDescription view = plainView(mesh, NamedView::top);
    view.colorMode = mode;
    return view;
}

}  // namespace

TEST(Colors, HeightColorsGrowBrighterEvenly) {
    double last = luminance(heightColor(0));
    EXPECT_GT(last, 60) << "the lowest points stand out from the background";
    for (int i = 1; i <= 20; ++i) {
        const double now = luminance(heightColor(i / 20.0));
        EXPECT_GT(now, last) << i;
        EXPECT_LT(now - last, 20) << i;
        last = now;
    }
    EXPECT_EQ(heightColor(-3), heightColor(0));
    EXPECT_EQ(heightColor(7), heightColor(1));
}

TEST(Colors, HeightScaleIgnoresAFewStrayPoints) {
    PointCloudBuilder builder;
    for (int i = 0; i < 1000; ++i) builder.add({0, 0, 30 + 0.002 * i});
    builder.add({0, 0, -500});
    builder.add({0, 0, 900});
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->vertices = std::move(builder).build();
    ViewDescription view = plainView(mesh, NamedView::top);
    view.colorMode = ColorMode::height;
    const auto scale = colorScale(view);
    ASSERT_TRUE(scale);
    EXPECT_NEAR(scale->low, 30, 0.1);
    EXPECT_NEAR(scale->high, 32, 0.1);
}

TEST(Colors, FollowTheMode) {
    const ViewDescription rgb = threePoints(ColorMode::rgb);
    const auto byColor = pointColors(rgb, 0, colorScale(rgb));
    EXPECT_EQ(byColor[0], (std::array<std::uint8_t, 4>{255, 0, 0, 255}));
    EXPECT_EQ(byColor[1], (std::array<std::uint8_t, 4>{0, 128, 0, 255}));
    EXPECT_EQ(byColor[2], (std::array<std::uint8_t, 4>{0, 0, 1, 255}));
    const ViewDescription intensity = threePoints(ColorMode::intensity);
    const auto byIntensity = pointColors(intensity, 0, colorScale(intensity));
    EXPECT_LT(byIntensity[0][0], byIntensity[1][0]);
    EXPECT_LE(byIntensity[1][0], byIntensity[2][0]);
    const ViewDescription height = threePoints(ColorMode::height);
    const auto byHeight = pointColors(height, 0, colorScale(height));
    EXPECT_GT(byHeight[0][2], byHeight[0][0]) << "low is blue";
    EXPECT_GT(byHeight[2][0], byHeight[2][2]) << "high is yellow";
}

TEST(Colors, RegistrationTintsTargetAndSourcesApart) {
    ViewDescription view = threePoints(ColorMode::rgb);
    view.layers.push_back(view.layers[0]);
    view.layers.push_back(view.layers[0]);
    view.layers[1].isTarget = true;
    view.overlay = Overlay::registration;
    const Rgb target = layerTint(view, 1);
    EXPECT_GT(target[2], target[0]);
    EXPECT_GT(layerTint(view, 0)[0], layerTint(view, 0)[2]);
    EXPECT_NE(layerTint(view, 0), layerTint(view, 2));
}

TEST(Colors, ResidualsRunFromCalmToRed) {
    ViewDescription view = threePoints(ColorMode::rgb);
    view.overlay = Overlay::residual;
    view.layers[0].residual_m =
        std::make_shared<std::vector<float>>(std::vector<float>{0.0F, 0.012F, 0.018F});
    const auto scale = colorScale(view);
    ASSERT_TRUE(scale);
    EXPECT_DOUBLE_EQ(scale->high, 0.02);
    const auto colors = pointColors(view, 0, scale);
    EXPECT_GT(colors[0][2], colors[0][0]);
    EXPECT_GT(colors[2][0], colors[2][2] + 60);
}
