#include <gtest/gtest.h>

#include <Eigen/LU>

#include "core/base/Parallel.h"
#include "core/base/Random.h"
#include "core/base/Units.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/registration/Register.h"
#include "core/simulation/TripodPair.h"

namespace vestige {
namespace {

constexpr double kChiSquare95 = 12.592;

TripodPairOptions street(std::uint64_t seed) {
    TripodPairOptions options;
    options.scene.seed = seed;
    options.seed = seed;
    options.distance_m = 4 + static_cast<double>(seed % 5) * 1.5;
    return options;
}

Result<RegistrationResult> registered(const TripodPair& pair, const Pose& start, int restarts) {
    ParameterSet parameters{registrationParameters()};
    EXPECT_TRUE(parameters.set("restarts", std::int64_t{restarts}));
    return attemptRegistration({pair.target, {}}, {pair.source, {}}, {start, 1}, parameters);
}

}  // namespace

TEST(Verdict, TheEllipsoidHoldsTheTruthAndRightOnesAreAccepted) {
    constexpr int kTrials = 14;
    int held = 0;
    int accepted = 0;
    for (std::uint64_t seed = 1; seed <= kTrials; ++seed) {
        const TripodPair pair = simulateTripodPair(street(seed));
        const Pose truth = pair.targetFromSource();
        const auto result = registered(pair, wrongPose(truth, 0.5, 4, seed), seed <= 2 ? 4 : 0);
        ASSERT_TRUE(result) << result.error().sentence();
        const PoseUncertainty uncertainty =
            result->quality->uncertainty.about(result->targetFromSource.pose.translation());
        Vector6d error;
        const Eigen::AngleAxisd turn(truth.linear() * result->targetFromSource.pose.linear().transpose());
        error << truth.translation() - result->targetFromSource.pose.translation(),
            turn.angle() * turn.axis();
        held += error.dot(uncertainty.covariance.ldlt().solve(error)) <= kChiSquare95;
        accepted += result->verdict == Verdict::accepted;
        EXPECT_FALSE(result->reasons.empty());
    }
    // Fewer than 11 of 14 have a chance below 1 in 200 where 95 % is true.
    EXPECT_GE(held, 11);
    EXPECT_GE(accepted, 12);
}

TEST(Verdict, WrongOnesAreNotAccepted) {
    int judged = 0;
    for (std::uint64_t seed = 1; seed <= 9; ++seed) {
        TripodPairOptions options = street(seed);
        if (seed % 3 == 2) options.scene.kind = TripodSceneKind::hall;
        if (seed % 3 == 0) options.sourceScene = TripodSceneOptions{TripodSceneKind::street, seed + 500};
        const TripodPair pair = simulateTripodPair(options);
        Pose move = Pose::Identity();
        if (seed % 3 == 1) move.translation() << 9, 0, 0;
        if (seed % 3 == 2)
            move.linear() = Eigen::AngleAxisd(radians(180), Eigen::Vector3d::UnitZ()).toRotationMatrix();
        const Pose start = pair.siteFromTarget.inverse() * move * pair.siteFromSource;
        const auto result = registered(pair, start, 2);
        if (!result) continue;  // no pose at all is no wrong one
        ++judged;
        const bool found =
            pair.overlaps &&
            (result->targetFromSource.pose.translation() - pair.targetFromSource().translation()).norm() <
                0.1;
        EXPECT_TRUE(found || result->verdict != Verdict::accepted) << "seed " << seed;
    }
    EXPECT_GE(judged, 7);
}

TEST(Verdict, AHallFromBehindDoesNotCastDoubtOnTheRightPose) {
    int accepted = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        TripodPairOptions options = street(seed);
        options.scene.kind = TripodSceneKind::hall;
        const TripodPair pair = simulateTripodPair(options);
        const auto result = registered(pair, wrongPose(pair.targetFromSource(), 0.3, 3, seed), 1);
        ASSERT_TRUE(result) << result.error().sentence();
        accepted += result->verdict == Verdict::accepted;
    }
    EXPECT_GE(accepted, 3);
}

TEST(Verdict, ABareRoadIsNotAcceptedAndSaysWhichWayItSlides) {
    TripodPairOptions options = street(3);
    options.scene.kind = TripodSceneKind::bareRoad;
    const TripodPair pair = simulateTripodPair(options);
    const auto result = registered(pair, pair.targetFromSource(), 0);
    ASSERT_TRUE(result) << result.error().sentence();
    EXPECT_NE(result->verdict, Verdict::accepted);
    ASSERT_EQ(result->quality->directions.size(), 6U);
    const ObservedDirection& least = result->quality->directions[0];
    const Eigen::Vector3d alongRoad = pair.siteFromTarget.linear().transpose() * Eigen::Vector3d::UnitX();
    EXPECT_GT(std::abs(least.direction.head<3>().normalized().dot(alongRoad)), 0.9);
    EXPECT_EQ(least.words.substr(0, 12), "slides level");
}

TEST(Verdict, AFlatRoadNamesTheThreeWaysThatNothingHolds) {
    const auto road = [](double length, double width, std::uint64_t seed) {
        Random random(seed);
        PointCloudBuilder builder{Eigen::Vector3d::Zero()};
        for (int i = 0; i < 30000; ++i) {
            const double x = random.uniform(-length / 2, length / 2);
            const double y = random.uniform(-width / 2, width / 2);
            builder.add({x, y, random.normal(0, 0.003)});
        }
        return std::move(builder).build();
    };
    Pose start = Pose::Identity();
    start.translation() << 0.1, 0.05, 0.01;
    const auto result = attemptRegistration({road(30, 8, 1), {}}, {road(6, 5, 2), {}}, {start, 1},
                                            ParameterSet{registrationParameters()});
    ASSERT_TRUE(result) << result.error().sentence();
    EXPECT_EQ(result->verdict, Verdict::doubtful);
    for (std::size_t i = 0; i < 6; ++i) {
        const ObservedDirection& one = result->quality->directions[i];
        EXPECT_EQ(one.free, i < 3) << one.words;
        if (one.free)
            EXPECT_GT(one.sigma_m, 1) << one.words;  // noise is no structure
        else
            EXPECT_LT(one.sigma_m, 0.002) << one.words;
    }
    EXPECT_LT(std::abs(result->quality->directions[0].direction.z()), 0.05);
    EXPECT_EQ(result->quality->directions[2].words, "turns about the vertical axis");
}

TEST(Verdict, IsTheSameBitsForAnyThreadCount) {
    const TripodPair pair = simulateTripodPair(street(5));
    const Pose start = wrongPose(pair.targetFromSource(), 0.3, 2, 5);
    setThreadCount(1);
    const auto one = registered(pair, start, 1);
    setThreadCount(5);
    const auto many = registered(pair, start, 1);
    setThreadCount(0);
    ASSERT_TRUE(one && many);
    EXPECT_EQ(one->quality->uncertainty.covariance, many->quality->uncertainty.covariance);
    EXPECT_EQ(one->quality->residuals.counts, many->quality->residuals.counts);
    EXPECT_EQ(one->reasons, many->reasons);
    EXPECT_EQ(one->quality->restarts.translation_m, many->quality->restarts.translation_m);
}

}  // namespace vestige
