#include "core/simulation/AerialScanner.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Parallel.h"
#include "core/simulation/ModelBuilder.h"
#include "core/simulation/SceneModel.h"

namespace vestige {
namespace {

SurfaceModel flatGround() {
    ModelBuilder builder;
    builder.part("ground").material(Material::asphalt);
    builder.quad({-200, -200, 0}, {200, -200, 0}, {200, 200, 0}, {-200, 200, 0});
    return builder.take();
}

AerialScan scan(const SurfaceModel& surfaces, const AerialOptions& options,
                const std::vector<Probe>& probes = {}) {
    const RayTracer tracer(surfaces);
    auto found = scanFromAir(tracer, surfaces, zenmuseL1(), options, ProbeCounter(probes, 0.04), {});
    EXPECT_TRUE(found);
    return std::move(*found);
}

TEST(AerialScanner, AFlatPatchShowsTheSheetsRangeNoise) {
    AerialOptions options;
    options.seconds = 0.2;  // too short for the slow errors of position and attitude to change
    options.flight.radius_m = 0.01;
    const AerialScan found = scan(flatGround(), options);
    double sum = 0;
    double squares = 0;
    double count = 0;
    for (std::size_t i = 0; i < found.cloud.size(); ++i) {
        const Eigen::Vector3d point = found.cloud.point(i);
        if (point.head<2>().norm() > 2) continue;
        sum += point.z();
        squares += point.z() * point.z();
        ++count;
    }
    ASSERT_GT(count, 2000);
    const double mean = sum / count;
    const double sigma = std::sqrt(squares / count - mean * mean);
    EXPECT_NEAR(sigma, 0.030, 0.0012);
    EXPECT_LT(std::abs(mean), 0.05) << "the slow error of height is centimetres";
}

TEST(AerialScanner, FiresAtTheSheetsRateAndTellsTime) {
    AerialOptions options;
    options.seconds = 0.05;
    options.gpsTime_s = 1000;
    options.worldFromSite = {518440, 4326120, 3};
    const AerialScan found = scan(flatGround(), options);
    EXPECT_EQ(found.pulses, 12000U);
    const PointAttributes& attributes = found.cloud.attributes();
    ASSERT_EQ(attributes.gpsTime.size(), found.cloud.size());
    EXPECT_GE(attributes.gpsTime.front(), 1000);
    EXPECT_LT(attributes.gpsTime.back(), 1000.05);
    EXPECT_GT(found.cloud.bounds().min.x(), 518300);
    for (const float intensity : attributes.intensity) EXPECT_LE(intensity, 52);  // asphalt: 0.20 x 255
}

TEST(AerialScanner, IsTheSameForAnyNumberOfThreadsAndOtherForAnotherSeed) {
    const auto scene = buildScene(twoCarsScene(), 1);
    ASSERT_TRUE(scene);
    AerialOptions options;
    options.seconds = 0.2;
    std::vector<AerialScan> scans;
    for (const int threads : {1, 2, 7}) {
        setThreadCount(threads);
        scans.push_back(scan(scene->surfaces, options));
    }
    setThreadCount(0);
    for (const AerialScan& other : {scans[1], scans[2]}) {
        EXPECT_EQ(scans[0].cloud.offsets(), other.cloud.offsets());
        EXPECT_EQ(scans[0].cloud.attributes().intensity, other.cloud.attributes().intensity);
    }
    options.seed = 2;
    EXPECT_NE(scans[0].cloud.offsets(), scan(scene->surfaces, options).cloud.offsets());
}

TEST(AerialScanner, TreesHideTheFrontOfTheCar) {
    SceneSpec spec = bicycleScene();
    const auto hidden = buildScene(spec, 1);
    std::erase_if(spec.objects, [](const ObjectSpec& object) { return object.kind->name == "tree"; });
    const auto open = buildScene(spec, 1);
    ASSERT_TRUE(hidden && open);
    const auto echoesOf = [](const SceneModel& scene, const std::string& feature) {
        const FeaturePoint* point = scene.surfaces.feature(feature);
        AerialOptions options;
        options.flight.target = {-1.2, 0.8, 0};
        options.flight.radius_m = 11;
        // A fast circle, so that a short flight looks from all sides.
        options.flight.secondsPerCircle = 4;
        options.seconds = 4;
        const RayTracer tracer(scene.surfaces);
        const ProbeCounter probes({{point->position, point->part}}, 0.15);
        return scanFromAir(tracer, scene.surfaces, zenmuseL1(), options, probes, {})->probeCounts[0];
    };
    const auto without = echoesOf(*open, "car.length_front");
    EXPECT_GT(without, 25U);
    EXPECT_LT(echoesOf(*hidden, "car.length_front"), without / 10);
}

}  // namespace
}  // namespace vestige
