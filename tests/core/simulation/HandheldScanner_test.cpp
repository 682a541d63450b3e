#include "core/simulation/HandheldScanner.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Parallel.h"
#include "core/simulation/ModelBuilder.h"

namespace vestige {
namespace {

SurfaceModel wall() {
    ModelBuilder builder;
    builder.part("wall").material(Material::whitePaint);
    builder.quad({0, -1, -1}, {0, 1, -1}, {0, 1, 1}, {0, -1, 1});
    builder.part("pane").material(Material::glass);
    builder.quad({0.1, 0.05, -1}, {0.1, 1, -1}, {0.1, 1, 1}, {0.1, 0.05, 1});
    return builder.take();
}

HandheldScan scanWall(std::uint64_t seed) {
    const SurfaceModel surfaces = wall();
    const RayTracer tracer(surfaces);
    HandheldSpec layer{"wall", "wall", 0.001, {}};
    layer.sweeps.push_back({{0.5, 0, 0}, {0.5, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0.2, 0.2, 1});
    auto found = scanByHand(tracer, surfaces, einScanPro2X(), layer, Pose::Identity(), seed,
                            ProbeCounter({{{0, 0, 0}, 0}}, 0.005), {});
    EXPECT_TRUE(found);
    return std::move(*found);
}

TEST(HandheldScanner, GivesMillimetresInItsOwnFrameWithTheSheetsNoise) {
    const HandheldScan scan = scanWall(1);
    EXPECT_EQ(scan.siteFromLayer.scale, 0.001);
    EXPECT_GT((scan.siteFromLayer.pose.linear() - Eigen::Matrix3d::Identity()).norm(), 0.1);
    EXPECT_GT(scan.cloud.bounds().diagonal(), 150) << "200 mm, not 0.2 m";
    double squares = 0;
    double count = 0;
    for (std::size_t i = 0; i < scan.cloud.size(); ++i) {
        const Eigen::Vector3d site = scan.siteFromLayer * scan.cloud.point(i);
        ASSERT_LT(std::abs(site.x()), 0.001);
        EXPECT_LT(site.y(), 0.064) << "nothing from behind or on the glass";
        squares += site.x() * site.x();
        ++count;
    }
    EXPECT_NEAR(std::sqrt(squares / count), 0.0001, 0.00001);
    // 200 x 100 mm (and a little behind the pane's edge) at 1 mm.
    EXPECT_GT(count, 15000);
    EXPECT_LT(count, 45000);
    EXPECT_GT(scan.probeCounts[0], 50U);
}

TEST(HandheldScanner, IsTheSameForAnyNumberOfThreadsAndOtherForAnotherSeed) {
    setThreadCount(1);
    const HandheldScan one = scanWall(1);
    setThreadCount(7);
    const HandheldScan seven = scanWall(1);
    setThreadCount(0);
    EXPECT_EQ(one.cloud.offsets(), seven.cloud.offsets());
    EXPECT_NE(one.cloud.offsets(), scanWall(2).cloud.offsets());
}

}  // namespace
}  // namespace vestige
