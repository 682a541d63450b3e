#include "core/simulation/Footprint.h"

#include <gtest/gtest.h>

#include "core/simulation/ModelBuilder.h"

namespace vestige {
namespace {

using Point = Eigen::Vector3d;

/// A beam straight down from 15 m whose long side lies along x.
std::vector<Echo> lookDown(const SurfaceModel& model, double x, std::uint64_t stream = 1) {
    const RayTracer tracer(model);
    const Footprint footprint(tracer, model, zenmuseL1());
    Eigen::Matrix3d axes;
    axes << -Point::UnitZ(), Point::UnitX(), Point::UnitY();
    Random random(1, stream);
    std::vector<Echo> found;
    footprint.echoes({x, 0, 15}, axes, random, found);
    return found;
}

SurfaceModel groundWithBlock(double height, Material top) {
    ModelBuilder builder;
    builder.part("ground").material(Material::asphalt);
    builder.quad({-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0});
    builder.part("block").material(top);
    if (height > 0) builder.box({1, 0, 0.5 * height}, {2, 2, height});
    return builder.take();
}

TEST(Footprint, OneSurfaceGivesOneEchoOfItsReflectance) {
    const std::vector<Echo> found = lookDown(groundWithBlock(0, Material::asphalt), 0);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].range_m, 15, 1e-5);
    EXPECT_NEAR(found[0].energy, opticsOf(Material::asphalt).reflectance905, 1e-6);
}

TEST(Footprint, AHighEdgeGivesTwoEchoes) {
    const std::vector<Echo> found = lookDown(groundWithBlock(2, Material::concrete), 0.005);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(found[0].range_m, 13, 1e-3);
    EXPECT_NEAR(found[1].range_m, 15, 1e-3);
    EXPECT_NE(found[0].part, found[1].part);
}

TEST(Footprint, ALowEdgeGivesOnePointBetween) {
    // 10 cm is below the range resolution: the point floats between top and ground.
    const std::vector<Echo> found = lookDown(groundWithBlock(0.10, Material::asphalt), 0.002);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_GT(found[0].range_m, 14.91);
    EXPECT_LT(found[0].range_m, 14.99);
    EXPECT_EQ(lookDown(groundWithBlock(0.10, Material::asphalt), 0.06)[0].range_m,
              lookDown(groundWithBlock(0.10, Material::asphalt), 0.5)[0].range_m)
        << "beyond half a spot the edge has no say";
}

TEST(Footprint, GlassLetsMostOfTheBeamThrough) {
    int onGlass = 0;
    int below = 0;
    int nothing = 0;
    const SurfaceModel model = groundWithBlock(1.5, Material::glass);
    for (std::uint64_t stream = 0; stream < 400; ++stream) {
        const std::vector<Echo> found = lookDown(model, 1, stream);
        nothing += found.empty();
        for (const Echo& echo : found) {
            onGlass += echo.range_m < 13.6;
            below += echo.range_m > 14.9;
        }
    }
    EXPECT_GT(below, 300);
    EXPECT_LT(onGlass, 250);
    EXPECT_LT(nothing, 20);
}

}  // namespace
}  // namespace vestige
