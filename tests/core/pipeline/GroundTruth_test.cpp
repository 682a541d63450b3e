#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <iostream>

#include "core/filters/Objects.h"
#include "core/io/FormatRegistry.h"
#include "core/simulation/AerialScanner.h"
#include "core/simulation/SceneModel.h"
#include "tests/support/TestPaths.h"

namespace vestige {
namespace {

/// The two cars' scene without what stands on its ground.
SurfaceModel groundAlone() {
    SceneSpec spec = twoCarsScene();
    std::erase_if(spec.objects, [](const ObjectSpec& object) { return object.kind->name != "ground"; });
    spec.measurements.clear();
    spec.handheld.clear();
    auto model = buildScene(spec, 1);
    EXPECT_TRUE(model);
    return std::move(model->surfaces);
}

TEST(GroundTruth, OfTheSimulatedCarsIsFoundAndTheCarsAreVehicles) {
    const SceneSpec spec = twoCarsScene();
    const auto model = buildScene(spec, 1);
    ASSERT_TRUE(model);
    const RayTracer tracer(model->surfaces);
    AerialOptions flight;
    flight.seconds = 5;
    flight.flight.target = {1.0, -0.3, 0};
    flight.flight.radius_m = 14;
    flight.worldFromSite = {518440, 4326120, 3.2};
    const auto scan = scanFromAir(tracer, model->surfaces, zenmuseL1(), flight, ProbeCounter({}, 0.04), {});
    ASSERT_TRUE(scan);
    const SurfaceModel bare = groundAlone();
    const RayTracer plumb(bare);

    const UprightPoints points(scan->cloud, {});
    const auto begin = std::chrono::steady_clock::now();
    const auto ground = findGround(points, {});
    ASSERT_TRUE(ground);
    std::vector<std::uint8_t> is(points.size(), 0);
    for (const std::uint32_t point : groundPoints(points, *ground)) is[point] = 1;
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;

    std::size_t onGround = 0, found = 0, standing = 0, taken = 0;
    std::vector<double> errors;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector3d site = scan->cloud.point(i) - flight.worldFromSite;
        // Round the cars, where it matters.
        if ((site.head<2>() - Eigen::Vector2d(1, -0.3)).norm() > 20) continue;
        const auto below = plumb.cast({static_cast<float>(site.x()), static_cast<float>(site.y()), 90.0F},
                                      {0, 0, -1}, 0, 200);
        if (!below) continue;
        const double height = site.z() - (90.0 - static_cast<double>(below->distance));
        errors.push_back(static_cast<double>(ground->heightAbove(points[i])) - height);
        if (std::abs(height) < 0.06) {
            ++onGround;
            found += is[i];
        } else if (height > 0.25) {
            ++standing;
            taken += is[i];
        }
    }
    double mean = 0, squares = 0;
    for (const double error : errors) mean += error / static_cast<double>(errors.size());
    for (const double error : errors) squares += (error - mean) * (error - mean);
    const double spread = std::sqrt(squares / static_cast<double>(errors.size()));
    const double recall = static_cast<double>(found) / static_cast<double>(onGround);
    const double wrong = static_cast<double>(taken) / static_cast<double>(standing);
    std::cout << points.size() << " points in " << took.count() << " s; of the ground " << recall
              << " found, of what stands on it " << wrong << " taken for ground; heights differ by " << mean
              << " m, spread " << spread << " m\n";
    EXPECT_GT(standing, 1000U);
    EXPECT_GT(recall, 0.97);
    EXPECT_LT(wrong, 0.002);
    EXPECT_LT(spread, 0.03) << "no more than one echo's noise, slow errors of the flight included";

    const auto objects = findObjects(points, *ground, {});
    ASSERT_TRUE(objects);
    const auto vehicleAt = [&](double x, double y) {
        for (const FoundObject& object : *objects) {
            Eigen::Vector3d centre = Eigen::Vector3d::Zero();
            for (const std::uint32_t point : object.points)
                centre += scan->cloud.point(point) / static_cast<double>(object.points.size());
            const double away = (centre - flight.worldFromSite - Eigen::Vector3d(x, y, 0)).head<2>().norm();
            if (object.kind == "vehicle" && away < 1.2) return object.box.length_m;
        }
        return 0.0;
    };
    EXPECT_NEAR(vehicleAt(3.0, -1.2), 4.88, 0.3) << "the white one";
    EXPECT_NEAR(vehicleAt(-2.4, 0.6), 4.93, 0.3) << "the black one";
}

TEST(GroundTruth, OfAnAirborneScanAgreesWithItsClasses) {
    VESTIGE_SHARED_OR_SKIP(file, "aerial/amsterdam/ahn/ahn_2386_9702.laz");
    const auto read = readGeometry(file, {}, {});
    ASSERT_TRUE(read) << read.error().sentence();
    const PointCloud& cloud = read->geometry.vertices;
    const auto& classes = cloud.attributes().classification;
    ASSERT_EQ(classes.size(), cloud.size());
    const UprightPoints points(cloud, {});
    GroundOptions options;
    options.cell_m = 1;
    const auto ground = findGround(points, options);
    ASSERT_TRUE(ground);
    std::size_t theirs = 0, both = 0, buildings = 0, wrong = 0;
    std::vector<std::uint8_t> is(points.size(), 0);
    for (const std::uint32_t point : groundPoints(points, *ground)) is[point] = 1;
    for (std::size_t i = 0; i < points.size(); ++i) {
        theirs += classes[i] == 2;
        both += classes[i] == 2 && is[i];
        buildings += classes[i] == 6;
        wrong += classes[i] == 6 && is[i];
    }
    std::cout << points.size() << " points, " << theirs << " of class ground, " << both << " of them found; "
              << buildings << " of class building, " << wrong << " of them taken for ground\n";
    EXPECT_GT(static_cast<double>(both), 0.9 * static_cast<double>(theirs));
    EXPECT_LE(static_cast<double>(wrong), 0.01 * static_cast<double>(buildings));
}

}  // namespace
}  // namespace vestige
