#include "core/registration/DenserSource.h"

#include <gtest/gtest.h>

#include "core/base/Parallel.h"
#include "core/base/Units.h"
#include "core/registration/FindPose.h"
#include "core/registration/Register.h"
#include "tests/core/registration/StreetScene.h"
#include "tests/core/registration/global/ParkingLot.h"

namespace vestige {
namespace {

/// A car's front in millimetres, scanned in its own frame, and a first pose that is 2 cm and 1 degree off.
struct RoughlyPlaced {
    PointCloud lot;
    PointCloud scan;
    Pose truth = Pose::Identity();
    Similarity start;

    RoughlyPlaced() {
        truth.translation() << 6, -3, 0;
        truth.rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()));
        const PointCloud all = test::parkingLot({truth});
        std::vector<std::uint32_t> some;
        for (std::uint32_t i = 0; i < all.size(); i += 5) some.push_back(i);
        lot = all.select(some);
        scan = test::carFront().transformed({Pose::Identity(), 1000});
        start = {truth, 0.001};
        start.pose.rotate(Eigen::AngleAxisd(radians(1), Eigen::Vector3d(1, 2, 2).normalized()));
        start.pose.translation() += Eigen::Vector3d(0.012, -0.008, 0.014);
    }
};

ParameterSet knownStart() {
    ParameterSet parameters(registrationParameters());
    EXPECT_TRUE(parameters.set("start_error_m", 0.02));
    return parameters;
}

TEST(DenserSource, AFineScanComesToLieOnACoarseTarget) {
    const RoughlyPlaced placed;
    const auto result = findPose(placed.lot, placed.scan, placed.start, knownStart());
    ASSERT_TRUE(result) << result.error().sentence();
    EXPECT_EQ(result->targetFromSource.scale, 0.001);
    const Eigen::Vector3d middle = placed.truth.translation();
    EXPECT_LT(test::distanceAt(result->targetFromSource.pose, placed.truth, placed.truth.inverse() * middle),
              0.004);
    EXPECT_LT(test::turnBetween(result->targetFromSource.pose, placed.truth), 0.2);
    ASSERT_FALSE(result->levels.empty());
    EXPECT_EQ(result->levels.back().targetFromSource.matrix(), result->targetFromSource.pose.matrix());
}

TEST(DenserSource, IsTheSameForAnyNumberOfThreads) {
    const RoughlyPlaced placed;
    const auto with = [&](int threads) {
        setThreadCount(threads);
        const auto result = findPose(placed.lot, placed.scan, placed.start, knownStart());
        setThreadCount(0);
        EXPECT_TRUE(result);
        return result->targetFromSource.pose;
    };
    EXPECT_EQ(with(1).matrix(), with(5).matrix());
}

TEST(DenserSource, LeavesOtherRegistrationsAlone) {
    const RoughlyPlaced placed;
    const auto found = [&](const PointCloud& target, const PointCloud& source,
                           const ParameterSet& parameters) {
        return findPoseOnDenserSource(target, source, placed.start, parameters, {}, {}).has_value();
    };
    EXPECT_TRUE(found(placed.lot, placed.scan, knownStart()));
    EXPECT_FALSE(found(placed.lot, placed.scan, ParameterSet(registrationParameters())));
    ParameterSet cells = knownStart();
    ASSERT_TRUE(cells.set("voxel_m", 0.3));
    EXPECT_FALSE(found(placed.lot, placed.scan, cells));
    // The target as fine as the source.
    const PointCloud car = placed.scan.transformed({placed.truth, 0.001});
    EXPECT_FALSE(found(car, placed.scan, knownStart()));
}

}  // namespace
}  // namespace vestige
