// Registration against exact truth: simulated accidents seen from two tripod stations. The full tables are
// made by tests/bench.
#include <gtest/gtest.h>

#include "core/base/Units.h"
#include "core/registration/FindPose.h"
#include "core/registration/Register.h"
#include "core/simulation/TripodPair.h"
#include "tests/core/registration/StreetScene.h"

namespace vestige {
namespace {

TripodPair accident(std::uint64_t seed, std::size_t points) {
    TripodPairOptions options;
    options.scene.seed = seed;
    options.seed = seed;
    options.points = points;
    return simulateTripodPair(options);
}

struct Off {
    double metres = 1e9;
    double degrees = 180;
};

Off registered(const TripodPair& pair, const Pose& start) {
    const ParameterSet parameters(registrationParameters());
    const auto result = findPose(pair.target, pair.source, {start, 1}, parameters);
    if (!result) return {};
    const Pose truth = pair.targetFromSource();
    return {test::distanceAt(result->targetFromSource.pose, truth, Eigen::Vector3d::Zero()),
            test::turnBetween(result->targetFromSource.pose, truth)};
}

TEST(TripodAccuracy, SixtyThousandPointsWithinTwoMillimetres) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const TripodPair pair = accident(seed, 60000);
        const Off off = registered(pair, wrongPose(pair.targetFromSource(), 0.5, 4, seed));
        EXPECT_LT(off.metres, 0.002) << "scene " << seed;
        EXPECT_LT(off.degrees, 0.01) << "scene " << seed;
    }
}

TEST(TripodAccuracy, AMillionPointsWithinHalfAMillimetre) {
    const TripodPair pair = accident(1, 1000000);
    const Off off = registered(pair, wrongPose(pair.targetFromSource(), 0.5, 4, 1));
    EXPECT_LT(off.metres, 0.0005);
    EXPECT_LT(off.degrees, 0.002);
}

TEST(TripodAccuracy, FindsThePoseFromFirstPosesFarOff) {
    const TripodPair pair = accident(1, 60000);
    for (const auto& [metres, angle] : {std::pair{1.0, 10.0}, {2.0, 20.0}}) {
        for (std::uint64_t start = 1; start <= 8; ++start) {
            const Off off = registered(pair, wrongPose(pair.targetFromSource(), metres, angle, start));
            EXPECT_LT(off.metres, 0.1) << metres << " m, start " << start;
            EXPECT_LT(off.degrees, 1) << metres << " m, start " << start;
        }
    }
}

}  // namespace
}  // namespace vestige
