#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/PointCloudBuilder.h"
#include "tests/ui/view/Samples.h"
#include "ui/view/PointColors.h"
#include "ui/view/ViewTheme.h"

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

TEST(Colors, DistancesDivergeRoundZeroAndReachThreeTimesTheirSpread) {
    ViewDescription view = threePoints(ColorMode::rgb);
    view.overlay = Overlay::residual;
    view.layers[0].residual_m =
        std::make_shared<std::vector<float>>(std::vector<float>{-0.012F, 0.001F, 0.012F});
    const auto scale = colorScale(view);
    ASSERT_TRUE(scale);
    EXPECT_DOUBLE_EQ(scale->low, -scale->high);
    EXPECT_GE(scale->high, 3 * *scale->noise);
    EXPECT_LE(scale->high, 4 * *scale->noise) << "rounded, not invented";
    const auto colors = pointColors(view, 0, scale);
    EXPECT_GT(colors[0][2], colors[0][0]) << "below is blue";
    EXPECT_GT(colors[2][0], colors[2][2]) << "above is orange";
    const auto missing = std::numeric_limits<float>::quiet_NaN();
    view.layers[0].residual_m =
        std::make_shared<std::vector<float>>(std::vector<float>{-0.012F, missing, 0.012F});
    const auto uncompared = pointColors(view, 0, scale)[1];
    EXPECT_EQ((Rgb{uncompared[0], uncompared[1], uncompared[2]}), uncomparedColor(Theme::dark));
}

TEST(Colors, TheSpreadIsThatOfTheNoiseAndNotOfAFewFarPoints) {
    ViewDescription view = threePoints(ColorMode::rgb);
    view.overlay = Overlay::residual;
    std::vector<float> distances;
    for (int i = 0; i < 2000; ++i) {
        // Quantiles of a normal distribution with 10 mm round a shift of 25 mm; one in ten is far off.
        const double u = (i + 0.5) / 2000;
        const double logit = std::log(u / (1 - u)) / 1.702;
        distances.push_back(static_cast<float>(i % 10 == 0 ? 1.5 : 0.025 + 0.010 * logit));
    }
    view.layers[0].residual_m = std::make_shared<std::vector<float>>(distances);
    const auto scale = colorScale(view);
    ASSERT_TRUE(scale && scale->noise);
    EXPECT_NEAR(*scale->noise, 0.010, 0.002);
    EXPECT_GT(scale->at(0.025)[0], scale->at(0)[0] - 40) << "a shift of the whole layer shows";
    EXPECT_NE(scale->at(0.025), scale->at(0));
}

namespace {

/// WCAG 2.1 relative luminance and contrast.
double linear(double part) {
    part /= 255;
    return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
}
double contrast(const Rgb& a, const Rgb& b) {
    const auto brightness = [](const Rgb& color) {
        return 0.2126 * linear(color[0]) + 0.7152 * linear(color[1]) + 0.0722 * linear(color[2]) + 0.05;
    };
    const double one = brightness(a);
    const double other = brightness(b);
    return std::max(one, other) / std::min(one, other);
}

Rgb backgroundOf(Theme theme) {
    const QColor color = viewTheme(theme).backgroundTop;
    return {static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()),
            static_cast<std::uint8_t>(color.blue())};
}

/// What a person without red (protanopia) or green (deuteranopia) cones sees: Vienot, Brettel and Mollon
/// 1999, in linear RGB.
Rgb asSeenWithout(bool red, const Rgb& color) {
    const double r = linear(color[0]);
    const double g = linear(color[1]);
    const double b = linear(color[2]);
    const double l = 17.8824 * r + 43.5161 * g + 4.11935 * b;
    const double m = 3.45565 * r + 27.1554 * g + 3.86714 * b;
    const double s = 0.0299566 * r + 0.184309 * g + 1.46709 * b;
    const double l2 = red ? 2.02344 * m - 2.52581 * s : l;
    const double m2 = red ? m : 0.494207 * l + 1.24827 * s;
    const double out[] = {0.0809444479 * l2 - 0.130504409 * m2 + 0.116721066 * s,
                          -0.0102485335 * l2 + 0.0540193266 * m2 - 0.113614708 * s,
                          -0.000365296938 * l2 - 0.00412161469 * m2 + 0.693511405 * s};
    Rgb seen;
    for (int i = 0; i < 3; ++i) {
        const double part = std::clamp(out[i], 0.0, 1.0);
        const double encoded = part <= 0.0031308 ? 12.92 * part : 1.055 * std::pow(part, 1 / 2.4) - 0.055;
        seen[i] = static_cast<std::uint8_t>(std::lround(255 * encoded));
    }
    return seen;
}

double apart(const Rgb& a, const Rgb& b) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum);
}

}  // namespace

TEST(Colors, StandOutFromTheBackgroundOfTheirTheme) {
    for (const Theme theme : {Theme::dark, Theme::light}) {
        const Rgb ground = backgroundOf(theme);
        for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            EXPECT_GT(contrast(heightColor(share, theme), ground), 1.8) << name(theme) << " height " << share;
            EXPECT_GT(contrast(differenceColor(2 * share - 1, theme), ground), 1.8) << name(theme) << share;
        }
        ViewDescription view = threePoints(ColorMode::source);
        view.theme = theme;
        view.layers.push_back(view.layers[0]);
        view.layers[0].isTarget = true;
        view.layers[0].tint = {250, 250, 240};
        EXPECT_GT(contrast(layerTint(view, 0), ground), 3) << "a white layer on white";
        view.overlay = Overlay::registration;
        EXPECT_GT(contrast(layerTint(view, 0), ground), 3);
        EXPECT_GT(contrast(layerTint(view, 1), ground), 3);
    }
}

TEST(Colors, SignsOfDistancesAreToldApartWithoutRedOrGreen) {
    for (const Theme theme : {Theme::dark, Theme::light})
        for (const bool red : {true, false}) {
            const Rgb below = asSeenWithout(red, differenceColor(-1, theme));
            const Rgb none = asSeenWithout(red, differenceColor(0, theme));
            const Rgb above = asSeenWithout(red, differenceColor(1, theme));
            EXPECT_GT(apart(below, above), 100) << name(theme);
            EXPECT_GT(apart(below, none), 60) << name(theme);
            EXPECT_GT(apart(above, none), 60) << name(theme);
        }
}
