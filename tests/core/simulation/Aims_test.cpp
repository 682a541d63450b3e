#include "core/simulation/Aims.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/geometry/Octree.h"
#include "core/geometry/Picking.h"
#include "core/simulation/HandheldScanner.h"
#include "core/simulation/SceneModel.h"

namespace vestige {
namespace {

/// The bicycle scene's car alone, and of its scan the sweeps of the right side's mirror and handle.
SceneSpec mirrorAndHandle() {
    SceneSpec spec = bicycleScene();
    std::erase_if(spec.objects, [](const ObjectSpec& object) { return object.id != "car"; });
    std::erase_if(spec.measurements, [](const MeasurementSpec& measurement) {
        return measurement.from.find("right_outer") == std::string::npos &&
               measurement.from.find("handle") == std::string::npos;
    });
    std::erase_if(spec.handheld[0].sweeps,
                  [](const SweepSpec& sweep) { return sweep.shots != 2 || sweep.atStart.x() < -1; });
    return spec;
}

class Aims : public testing::Test {
  protected:
    void SetUp() override {
        spec_ = mirrorAndHandle();
        ASSERT_EQ(spec_.measurements.size(), 2U);
        auto scene = buildScene(spec_, 1);
        ASSERT_TRUE(scene);
        scene_ = std::move(*scene);
        std::vector<Probe> probes;
        for (const FeaturePoint& feature : scene_.surfaces.features)
            probes.push_back({feature.position, feature.part});
        const RayTracer tracer(scene_.surfaces);
        auto scan = scanByHand(tracer, scene_.surfaces, einScanPro2X(), spec_.handheld[0], Pose::Identity(),
                               1, ProbeCounter(probes, 0.005), {});
        ASSERT_TRUE(scan);
        scan_ = std::move(*scan);
        ShownLayer front{"front", "lidar", true, true, scan_.siteFromLayer.inverse(), 0.00025, 0.6, {}};
        for (const std::uint32_t count : scan_.probeCounts) front.shows.push_back(count >= 20);
        ShownLayer aerial{"aerial", "lidar", false, false, {}, 0.002, 2, {}};
        aerial.shows.resize(front.shows.size(), false);
        layers_ = {aerial, front};
    }

    /// What the pipeline does with an aim: the view moves with its layer, and pickPoint says what was hit.
    std::optional<Eigen::Vector3d> hit(const Octree& octree, const Aiming& aiming, const SimulatedAim& aim) {
        ViewCamera camera = aiming.views.at(aim.view).camera;
        camera.position = scan_.siteFromLayer * camera.position;
        camera.focalPoint = scan_.siteFromLayer * camera.focalPoint;
        camera.viewUp = scan_.siteFromLayer.pose.linear() * camera.viewUp;
        const PickLayer layer{1, &octree, scan_.siteFromLayer};
        const auto pick = pickPoint(std::span(&layer, 1), camera, aim.pixel);
        return pick ? std::optional(pick->world) : std::nullopt;
    }

    SceneSpec spec_;
    SceneModel scene_;
    HandheldScan scan_;
    std::vector<ShownLayer> layers_;
};

TEST_F(Aims, OfHiddenPartsMeasureThemToOnePercent) {
    const Aiming aiming = aimAtFeatures(spec_, scene_.surfaces, layers_, {});
    const Octree octree(std::make_shared<const PointCloud>(scan_.cloud));
    for (const AimedMeasurement& measured : aiming.measurements) {
        ASSERT_TRUE(measured.aims.contains("lidar")) << measured.object;
        double sum = 0;
        std::vector<double> lengths;
        for (const auto& [a, b] : measured.aims.at("lidar")) {
            EXPECT_EQ(a.layer, "front");
            const auto from = hit(octree, aiming, a);
            const auto to = hit(octree, aiming, b);
            ASSERT_TRUE(from && to) << measured.object;
            lengths.push_back((*to - *from).norm());
            sum += lengths.back();
        }
        ASSERT_EQ(lengths.size(), 3U);
        EXPECT_NE(lengths[0], lengths[1]);
        EXPECT_LT(std::abs(sum / 3 / measured.tape_m - 1), 0.01) << measured.object << " " << sum / 3;
    }
}

TEST_F(Aims, WithoutTheHandheldLayerThereAreNone) {
    layers_.pop_back();
    for (const AimedMeasurement& measured : aimAtFeatures(spec_, scene_.surfaces, layers_, {}).measurements)
        EXPECT_TRUE(measured.aims.empty());
}

TEST_F(Aims, PointWithTheStatedErrorAndAnother) {
    double squares = 0;
    double count = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        AimOptions options;
        options.seed = seed;
        const Aiming aiming = aimAtFeatures(spec_, scene_.surfaces, layers_, options);
        const MeasurementSpec& spec = spec_.measurements[0];
        for (const auto& [a, b] : aiming.measurements[0].aims.at("lidar")) {
            for (const auto& [aim, name] : {std::pair(a, spec.from), std::pair(b, spec.to)}) {
                const Eigen::Vector3d truth =
                    scan_.siteFromLayer.inverse() * scene_.surfaces.feature(name)->position;
                squares += (aim.pixel - aiming.views.at(aim.view).camera.project(truth)->pixel).squaredNorm();
                count += 2;
            }
        }
    }
    EXPECT_NEAR(std::sqrt(squares / count), 2, 0.15);
}

}  // namespace
}  // namespace vestige
