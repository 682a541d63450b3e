#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Hash.h"
#include "core/base/Parallel.h"
#include "core/base/Units.h"
#include "core/io/FormatRegistry.h"
#include "core/simulation/PavilionScene.h"
#include "core/simulation/SimulateSequence.h"
#include "tests/support/TestPaths.h"

namespace vestige {
namespace {

/// A level floor at z = 0 and a wall at x = 4 from y = 0 on: left of the scanner's axis the wall, right of it
/// nothing but floor.
SurfaceModel yard() {
    ModelBuilder builder;
    builder.part("floor").material(Material::concrete);
    builder.quad({-20, -20, 0}, {20, -20, 0}, {20, 20, 0}, {-20, 20, 0});
    builder.part("wall");
    builder.quad({4, 0, 0}, {4, 20, 0}, {4, 20, 6}, {4, 0, 6});
    return builder.take();
}

TEST(TiltingScanner, MeasuresPlanesToItsNoise) {
    const SurfaceModel surfaces = yard();
    const RayTracer tracer(surfaces);
    TiltingOptions options;
    options.worldFromScanner.translation() << 0, 0, 1.2;
    options.worldFromScanner.linear() = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    options.beams = 20000;
    options.falseRanges = 0;
    const auto points = scanTilting(tracer, surfaces, hokuyoUtm30Lx(), options, {});
    ASSERT_TRUE(points);
    std::size_t onWall = 0;
    double squares = 0;
    for (const TiltedPoint& point : *points) {
        const Eigen::Vector3d at = options.worldFromScanner * point.position;
        const double range = point.position.norm();
        const Eigen::Vector3d beam = options.worldFromScanner.linear() * point.position / range;
        EXPECT_GT(range, hokuyoUtm30Lx().nearest_m);
        EXPECT_LT(range, hokuyoUtm30Lx().farthest_m + 0.2);
        if (std::abs(at.x() - 4) > 0.3 || at.y() < 0.5 || at.z() < 0.5 || range > 9) continue;
        ++onWall;
        squares += std::pow((4 - options.worldFromScanner.translation().x()) / beam.x() - range, 2);
    }
    ASSERT_GT(onWall, 500U);
    // The mean over the beam's rays adds next to nothing to the noise on a facing wall.
    EXPECT_NEAR(std::sqrt(squares / static_cast<double>(onWall)), hokuyoUtm30Lx().noiseNear_m, 0.001);
}

TEST(TiltingScanner, SweepsItsFieldOfViewLineByLine) {
    const SurfaceModel surfaces = yard();
    const RayTracer tracer(surfaces);
    TiltingOptions options;
    options.worldFromScanner.translation() << 0, 0, 1.2;
    options.beams = 20000;
    const auto points = scanTilting(tracer, surfaces, hokuyoUtm30Lx(), options, {});
    ASSERT_TRUE(points);
    double lowest = 0, highest = 0;
    for (std::size_t i = 0; i < points->size(); ++i) {
        const TiltedPoint& point = (*points)[i];
        // Turned back by its line's tilt the point lies in the scanned plane: elevation over the front.
        const double level =
            std::atan2(point.position.y(), std::hypot(point.position.x(), point.position.z()));
        EXPECT_LT(std::abs(level), radians(90.1));
        if (point.position.x() > 0.5) {
            const double tilt = std::atan2(point.position.z(), point.position.x());
            lowest = std::min(lowest, tilt);
            highest = std::max(highest, tilt);
        }
        if (i == 0) continue;
        const TiltedPoint& before = (*points)[i - 1];
        EXPECT_TRUE(point.line > before.line || (point.line == before.line && point.beam > before.beam));
        EXPECT_GT(point.time_s, before.time_s);
    }
    EXPECT_NEAR(lowest, options.tiltFrom_rad, 0.03);
    EXPECT_GT(highest, 0.7);  // the wall's top
}

TEST(Pavilion, WalkIsAsLongAsAStrideTimesItsStops) {
    const std::vector<Pose> walk = pavilionWalk(32, 1);
    ASSERT_EQ(walk.size(), 32U);
    double length = 0;
    for (std::size_t i = 1; i < walk.size(); ++i) {
        const Pose step = walk[i - 1].inverse() * walk[i];
        length += step.translation().norm();
        EXPECT_GT(step.translation().norm(), 0.4);
        EXPECT_LT(step.translation().norm(), 0.8);
        EXPECT_LT(rotationAngle(step.linear()), radians(20.0));
        EXPECT_GT(step.translation().x(), 0.3) << "forward";
    }
    EXPECT_GT(length, 15);
    EXPECT_LT(length, 20);
    EXPECT_EQ(pavilionWalk(3, 1).size(), 3U);
    EXPECT_NE(pavilionWalk(3, 2)[0].matrix(), pavilionWalk(3, 1)[0].matrix());
}

TEST(Pavilion, SequencesAreTheSameForAnyNumberOfThreads) {
    const test::TemporaryFolder folder;
    SequenceOptions options;
    options.scans = 2;
    options.beams = 4000;
    std::vector<std::string> hashes[2];
    for (const int threads : {1, 2}) {
        setThreadCount(threads);
        const auto made = simulatePavilion(options, folder / std::to_string(threads), {});
        setThreadCount(0);
        ASSERT_TRUE(made) << made.error().sentence();
        EXPECT_EQ(made->files,
                  (std::vector<std::string>{"Hokuyo_0.csv", "Hokuyo_1.csv", "pose_scanner_leica.csv"}));
        for (const std::string& file : made->files)
            hashes[threads - 1].push_back(*sha256OfFile(folder / std::to_string(threads) / file));
        const auto cloud = readGeometry(folder / std::to_string(threads) / "Hokuyo_0.csv");
        ASSERT_TRUE(cloud) << cloud.error().sentence();
        EXPECT_EQ(cloud->geometry.vertices.size(), made->points[0]);
        // Walls, roof and trees stand round the scanner; only sky gives nothing.
        EXPECT_GT(made->points[0], options.beams / 2);
    }
    EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(Pavilion, StandsStillBetweenTheScansOfBothFrames) {
    // The same scan in the two layouts: the world's is the scanner's moved by its pose, to the digits
    // written.
    const test::TemporaryFolder folder;
    SequenceOptions options;
    options.scans = 2;
    options.beams = 2000;
    ASSERT_TRUE(simulatePavilion(options, folder / "scanner", {}));
    options.frame = AslFrame::world;
    ASSERT_TRUE(simulatePavilion(options, folder / "world", {}));
    const auto own = readGeometry(folder / "scanner" / "Hokuyo_1.csv");
    const auto world = readGeometry(folder / "world" / "PointCloud1.csv");
    ASSERT_TRUE(own && world);
    const Pose pose = pavilionWalk(2, options.seed)[1];
    ASSERT_EQ(own->geometry.vertices.size(), world->geometry.vertices.size());
    for (std::size_t i = 0; i < own->geometry.vertices.size(); ++i)
        EXPECT_LT((pose * own->geometry.vertices.point(i) - world->geometry.vertices.point(i)).norm(), 2e-4);
}

}  // namespace
}  // namespace vestige
