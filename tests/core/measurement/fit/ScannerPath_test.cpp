#include "core/measurement/fit/ScannerPath.h"

#include <gtest/gtest.h>

#include "core/base/Units.h"
#include "tests/core/measurement/fit/FitClouds.h"

namespace vestige {
namespace {

using Vec = Eigen::Vector3d;

/// A scanner that flies along x at 3 m/s, 15 m above the ground with a box on it: a top of 0.5 x 0.8 m at
/// 0.6 m height. Beams that meet its rim bring a second echo from the ground.
PointCloud flownOver(std::uint64_t seed, double noise_m) {
    Random random(seed, 1);
    PointCloudBuilder builder(Vec(500000, 4300000, 0));
    PointAttributes& attributes = builder.attributes();
    const auto add = [&](const Vec& from, const Vec& point, double noise, double time, int number, int count,
                         float intensity) {
        builder.add(Vec(500000, 4300000, 0) + point + noise * (point - from).normalized());
        attributes.gpsTime.push_back(time);
        attributes.returnNumber.push_back(static_cast<std::uint8_t>(number));
        attributes.returnCount.push_back(static_cast<std::uint8_t>(count));
        attributes.intensity.push_back(intensity);
    };
    for (int pulse = 0; pulse < 60000; ++pulse) {
        const double time = 1000 + 8.0 * pulse / 60000;
        const Vec from(-12 + 3 * (time - 1000), -6, 15);
        const Vec aim(random.uniform(-1, 1), random.uniform(-1, 1), 0.6);
        const double noise = random.normal(0, noise_m);
        const bool onTop = std::abs(aim.x()) < 0.25 && std::abs(aim.y()) < 0.4;
        const Vec beam = (aim - from).normalized();
        const Vec ground = from - from.z() / beam.z() * beam;
        const bool rim = onTop && std::abs(aim.x()) > 0.22;
        if (onTop) add(from, aim, noise, time, 1, rim ? 2 : 1, 50);
        if (!onTop || rim) add(from, ground, noise, time, rim ? 2 : 1, rim ? 2 : 1, 50);
    }
    return std::move(builder).build();
}

TEST(ScannerPath, IsFoundWhereItWas) {
    const PointCloud cloud = flownOver(1, 0.03);
    const auto path = ScannerPath::recovered(cloud);
    ASSERT_TRUE(path);
    for (const double time : {1000.5, 1003.2, 1007.5}) {
        const auto place = path->at(time);
        ASSERT_TRUE(place);
        EXPECT_LT((*place - Vec(500000 - 12 + 3 * (time - 1000), 4300000 - 6, 15)).norm(), 0.3) << time;
    }
    EXPECT_FALSE(path->at(900));
    EXPECT_FALSE(path->at(2000));
}

TEST(ScannerPath, NeedsTimesAndSeveralEchoes) {
    EXPECT_FALSE(ScannerPath::recovered(PointCloud()));
    fit_test::Cloud cloud(1, 0.03);
    cloud.patch({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 100, {0, 0, -1});
    EXPECT_FALSE(ScannerPath::recovered(cloud.octree()->cloud()));
}

TEST(ScannerPath, LetsEdgesBeReadFromTheBeamsAlongThem) {
    const auto cloud = std::make_shared<const PointCloud>(flownOver(2, 0.03));
    const auto path = ScannerPath::recovered(*cloud);
    ASSERT_TRUE(path);
    const Octree octree(cloud);
    double width = 0;
    for (const double side : {-1.0, 1.0}) {
        SnapRequest asked = fit_test::request(octree, {0.01, side * 0.4, 0.62}, 0.03);
        asked.path = &*path;
        const auto edge = snapFeature(asked, SnapMode::edge);
        ASSERT_TRUE(edge) << edge.error().sentence();
        EXPECT_GT(std::abs(edge->axis.x()), 0.97);
        width += side * (edge->position.y() - 4300000);
    }
    EXPECT_NEAR(width, 0.8, 0.016);
}

}  // namespace
}  // namespace vestige
