#include "core/registration/global/FirstPose.h"

#include <gtest/gtest.h>

#include "core/base/Parallel.h"
#include "core/base/Units.h"
#include "core/io/FormatRegistry.h"
#include "core/registration/InitialPose.h"
#include "core/registration/Register.h"
#include "tests/core/registration/StreetScene.h"
#include "tests/core/registration/global/ParkingLot.h"
#include "tests/support/TestPaths.h"

namespace vestige {
namespace {

using test::anyPose;
using test::carFront;
using test::distanceAt;
using test::parkingLot;
using test::turnBetween;

ParameterSet defaults() {
    return ParameterSet(registrationParameters());
}

/// A scan in a frame of its own, and the pose that takes it back.
struct MovedScan {
    PointCloud cloud;
    Pose back;
};

/// `scan` (metres) turned and shifted at random, in `metresPerUnit`.
MovedScan moved(const PointCloud& scan, double metresPerUnit, std::uint64_t seed) {
    const Pose away = anyPose(seed);
    return {scan.transformed({away, 1}).transformed({Pose::Identity(), 1 / metresPerUnit}), away.inverse()};
}

void expectNear(const Pose& found, const Pose& truth, const Eigen::Vector3d& middle, double shift_m,
                double turn_deg) {
    EXPECT_LT(distanceAt(found, truth, truth.inverse() * middle), shift_m);
    EXPECT_LT(turnBetween(found, truth), turn_deg);
}

Pose at(double x, double y, double yaw) {
    Pose pose = Pose::Identity();
    pose.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    pose.translation() << x, y, 0;
    return pose;
}

std::string notesOf(const FirstPose& found) {
    std::string text;
    for (const std::string& note : found.notes) text += note + "\n";
    return text;
}

TEST(FirstPose, FindsACarsFrontAmongOtherThingsFromAnyPoseAndUnit) {
    const Pose car = at(6, -3, 0.7);
    const TriangleMesh lot{parkingLot({car}), {}};
    for (const auto& [unit, seed] : {std::pair{0.001, 1}, {1.0, 2}, {0.001, 3}}) {
        const MovedScan scan = moved(carFront(), unit, static_cast<std::uint64_t>(seed));
        const auto found = findFirstPose(lot, {scan.cloud, {}}, {}, defaults());
        ASSERT_TRUE(found) << found.error().sentence();
        EXPECT_EQ(found->targetFromSource.scale, unit);
        EXPECT_FALSE(found->ambiguous) << notesOf(*found);
        EXPECT_TRUE(found->error_m);
        expectNear(found->targetFromSource.pose, car * scan.back, car.translation(), 0.05, 2);
    }
}

TEST(FirstPose, NamesBothOfTwoEqualCars) {
    const Pose one = at(6, -3, 0.7);
    const Pose two = at(-7, 5, -2);
    const MovedScan scan = moved(carFront(), 0.001, 4);
    const auto found = findFirstPose({parkingLot({one, two}), {}}, {scan.cloud, {}}, {}, defaults());
    ASSERT_TRUE(found) << found.error().sentence();
    EXPECT_TRUE(found->ambiguous);
    ASSERT_GE(found->candidates.size(), 2U);
    EXPECT_GE(found->candidates[0].score, found->candidates[1].score);
    for (const Pose& car : {one, two}) {
        const bool named =
            std::any_of(found->candidates.begin(), found->candidates.begin() + 2, [&](const auto& c) {
                const Pose truth = car * scan.back;
                return distanceAt(c.targetFromSource.pose, truth, truth.inverse() * car.translation()) <
                           0.05 &&
                       turnBetween(c.targetFromSource.pose, truth) < 2;
            });
        EXPECT_TRUE(named) << car.translation().transpose();
    }
    RegistrationResult result;
    addFirstPose(result, *found);
    EXPECT_EQ(result.verdict, Verdict::ambiguous);
    EXPECT_EQ(result.candidates.size(), found->candidates.size());
}

TEST(FirstPose, FindsNothingWhereThereIsNothing) {
    const MovedScan scan = moved(carFront(), 0.001, 5);
    const TriangleMesh lot{parkingLot({}), {}};
    const auto found = findFirstPose(lot, {scan.cloud, {}}, {}, defaults());
    if (!found) {
        EXPECT_EQ(found.error().code, ErrorCode::untrustworthy);
        return;
    }
    // Where something is proposed none the less, it must not be relied on.
    ParameterSet parameters = defaults();
    if (found->error_m) {
        ASSERT_TRUE(parameters.set("start_error_m", *found->error_m));
    }
    auto result = attemptRegistration(lot, {scan.cloud, {}}, found->targetFromSource, parameters);
    if (!result) return;
    addFirstPose(*result, *found);
    EXPECT_NE(result->verdict, Verdict::accepted) << notesOf(*found);
}

TEST(FirstPose, IsTheSameForAnyNumberOfThreads) {
    const MovedScan scan = moved(carFront(), 0.001, 6);
    const TriangleMesh lot{parkingLot({at(6, -3, 0.7), at(-7, 5, -2)}), {}};
    const auto with = [&](int threads) {
        setThreadCount(threads);
        const auto found = findFirstPose(lot, {scan.cloud, {}}, {}, defaults());
        setThreadCount(0);
        EXPECT_TRUE(found);
        return *found;
    };
    const FirstPose one = with(1);
    const FirstPose many = with(5);
    ASSERT_EQ(one.candidates.size(), many.candidates.size());
    for (std::size_t i = 0; i < one.candidates.size(); ++i) {
        EXPECT_EQ(one.candidates[i].targetFromSource.pose.matrix(),
                  many.candidates[i].targetFromSource.pose.matrix());
        EXPECT_EQ(one.candidates[i].score, many.candidates[i].score);
    }
}

TEST(FirstPose, StopsWhenCancelled) {
    const MovedScan scan = moved(carFront(), 0.001, 6);
    JobControl control;
    control.cancel();
    const auto found = findFirstPose({parkingLot({}), {}}, {scan.cloud, {}}, {}, defaults(), control);
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().code, ErrorCode::cancelled);
}

TEST(FirstPose, LaysTwoStationsOnEachOther) {
    test::Station first;
    test::Station second;
    first.worldFromScanner.translation() << 0, 0, 1.7;
    second.worldFromScanner = at(5, 1.5, 1.1);
    second.worldFromScanner.translation().z() = 1.6;
    second.seed = 2;
    const TriangleMesh target{scanStreet(first), {}};
    const PointCloud source = scanStreet(second);
    for (const std::uint64_t seed : {7U, 8U}) {
        const MovedScan scan = moved(source, 1, seed);
        const auto found = findFirstPose(target, {scan.cloud, {}}, 1.0, defaults());
        ASSERT_TRUE(found) << found.error().sentence();
        EXPECT_FALSE(found->ambiguous);
        const Pose truth = first.worldFromScanner.inverse() * second.worldFromScanner * scan.back;
        const auto result = registerGeometry(target, {scan.cloud, {}}, found->targetFromSource, defaults());
        ASSERT_TRUE(result) << result.error().sentence();
        expectNear(result->targetFromSource.pose, truth, {0, 0, 0}, 0.05, 0.3);
    }
}

/// The share of `trials` random poses from which the source comes to lie on the target as the picked pairs
/// say.
int placedAsPicked(const std::string& target, const std::string& source, const std::string& picks, int trials,
                   double shift_m) {
    const auto there = readGeometry(target);
    const auto here = readGeometry(source);
    const auto pairs = readPointPairs(test::dataFile("registration/" + picks));
    EXPECT_TRUE(there && here && pairs);
    const Pose picked = alignPairs(*pairs, 1)->targetFromSource.pose;
    const Eigen::Vector3d middle = here->geometry.vertices.bounds().centre();
    int placed = 0;
    for (int trial = 0; trial < trials; ++trial) {
        const MovedScan scan = moved(here->geometry.vertices, 1, 20 + static_cast<std::uint64_t>(trial));
        const auto found = findFirstPose(there->geometry, {scan.cloud, {}}, 1.0, defaults());
        if (!found) continue;
        const Pose pose = found->targetFromSource.pose * scan.back.inverse();
        placed += distanceAt(pose, picked, middle) < shift_m && turnBetween(pose, picked) < 2;
    }
    return placed;
}

TEST(FirstPose, LaysARoomOnItselfAsPickedPairsDo) {
    VESTIGE_SHARED_OR_SKIP(target, "registration/room/room_scan1.pcd");
    VESTIGE_SHARED_OR_SKIP(source, "registration/room/room_scan2.pcd");
    EXPECT_EQ(placedAsPicked(target, source, "room_picks.csv", 2, 0.2), 2);
}

TEST(FirstPose, LaysADragonOnItselfAsPickedPairsDo) {
    VESTIGE_SHARED_OR_SKIP(target, "registration/objects/dragon1.xyz");
    VESTIGE_SHARED_OR_SKIP(source, "registration/objects/dragon2.xyz");
    EXPECT_EQ(placedAsPicked(target, source, "dragon_picks.csv", 2, 0.2), 2);
}

TEST(FirstPose, LaysRealScansOnEachOtherFromAnyPose) {
    VESTIGE_SHARED_OR_SKIP(targetFile, "registration/apartment/cloud_0.vtk");
    VESTIGE_SHARED_OR_SKIP(sourceFile, "registration/apartment/cloud_1.vtk");
    const auto target = readGeometry(targetFile);
    const auto source = readGeometry(sourceFile);
    ASSERT_TRUE(target && source);
    for (const std::uint64_t seed : {9U, 10U, 11U}) {
        const MovedScan scan = moved(source->geometry.vertices, 1, seed);
        const auto found = findFirstPose(target->geometry, {scan.cloud, {}}, {}, defaults());
        ASSERT_TRUE(found) << found.error().sentence();
        EXPECT_FALSE(found->ambiguous);
        // Two published results: see RealPairs_test.cpp.
        const Pose pose = found->targetFromSource.pose * scan.back.inverse();
        EXPECT_LT((pose.translation() - Eigen::Vector3d(0.6083, -0.0039, 0.0107)).norm(), 0.1);
        EXPECT_NEAR(degrees(rotationAngle(pose.linear())), 6.6, 1);
    }
}

}  // namespace
}  // namespace vestige
