#include "core/simulation/TripodPair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include "core/base/Parallel.h"
#include "core/base/Units.h"

namespace vestige {
namespace {

TripodPairOptions small(std::uint64_t seed) {
    TripodPairOptions options;
    options.scene.seed = seed;
    options.seed = seed;
    options.points = 8000;
    return options;
}

/// How far points of `cloud` lie from the scene's surfaces, along the ray from the station through them.
std::vector<double> residuals(const TripodScene& scene, const PointCloud& cloud,
                              const Pose& siteFromScanner) {
    std::vector<double> all;
    const Eigen::Vector3f from = siteFromScanner.translation().cast<float>();
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const Eigen::Vector3d inSite = siteFromScanner * cloud.point(i);
        const Eigen::Vector3d ray = inSite - siteFromScanner.translation();
        double best = 1;
        for (float nearest = static_cast<float>(ray.norm()) - 0.05F;;) {
            const auto hit = scene.tracer().cast(from, ray.normalized().cast<float>(), nearest,
                                                 static_cast<float>(ray.norm()) + 0.05F);
            if (!hit) break;
            const double off = ray.norm() - static_cast<double>(hit->distance);
            if (std::abs(off) < std::abs(best)) best = off;
            nearest = hit->distance + 1e-3F;
        }
        all.push_back(best);
    }
    return all;
}

TEST(TripodPair, BothCloudsLieOnTheSceneWithinTheNoise) {
    const TripodPairOptions options = small(3);
    const TripodScene scene(options.scene);
    const TripodPair pair = simulateTripodPair(scene, scene, options);
    // The source goes by way of the true pose, as a registration would take it.
    const Pose siteFromSource = pair.siteFromTarget * pair.targetFromSource();
    for (const auto& off : {residuals(scene, pair.target, pair.siteFromTarget),
                            residuals(scene, pair.source, siteFromSource)}) {
        double sum = 0;
        double squares = 0;
        std::size_t far = 0;
        for (const double one : off) {
            if (std::abs(one) > 0.03) {
                ++far;  // float rounding at an edge
                continue;
            }
            sum += one;
            squares += one * one;
        }
        const auto count = static_cast<double>(off.size() - far);
        EXPECT_LE(far, off.size() / 500);
        EXPECT_NEAR(std::sqrt(squares / count), 0.003, 0.0002);
        EXPECT_NEAR(sum / count, 0, 0.00015);
    }
}

TEST(TripodPair, StationsStandAsAskedAndOverlap) {
    for (const std::uint64_t seed : {1, 2, 5, 9}) {
        const TripodPair pair = simulateTripodPair(small(seed));
        EXPECT_TRUE(pair.overlaps);
        const Pose truth = pair.targetFromSource();
        EXPECT_NEAR(truth.translation().head<2>().norm(), 12.8, 1e-9);
        EXPECT_LT(std::abs(truth.translation().z()), 0.5);
        EXPECT_NEAR(degrees(rotationAngle(truth.linear())), 27, 1e-9);
        for (const PointCloud* cloud : {&pair.target, &pair.source})
            EXPECT_NEAR(static_cast<double>(cloud->size()), 8000, 320) << seed;
    }
}

TEST(TripodPair, NoPlaceIsSampledTwice) {
    const TripodPair pair = simulateTripodPair(small(4));
    std::set<std::array<float, 3>> target;
    for (std::size_t i = 0; i < pair.target.size(); ++i) {
        const Eigen::Vector3f site = (pair.siteFromTarget * pair.target.point(i)).cast<float>();
        target.insert({site.x(), site.y(), site.z()});
    }
    EXPECT_GT(target.size() + 2, pair.target.size());
    std::size_t shared = 0;
    for (std::size_t i = 0; i < pair.source.size(); ++i) {
        const Eigen::Vector3f site = (pair.siteFromSource * pair.source.point(i)).cast<float>();
        shared += target.count({site.x(), site.y(), site.z()});
    }
    EXPECT_EQ(shared, 0U);
}

TEST(TripodPair, SameSeedSamePairForAnyThreads) {
    setThreadCount(1);
    const TripodPair one = simulateTripodPair(small(6));
    setThreadCount(3);
    const TripodPair three = simulateTripodPair(small(6));
    setThreadCount(0);
    EXPECT_EQ(one.target.offsets(), three.target.offsets());
    EXPECT_EQ(one.source.offsets(), three.source.offsets());
    EXPECT_EQ(one.siteFromSource.matrix(), three.siteFromSource.matrix());
    EXPECT_NE(one.source.offsets(), simulateTripodPair(small(7)).source.offsets());
}

TEST(TripodPair, AnAccidentSceneHoldsWhatItShould) {
    const SurfaceModel scene = buildTripodScene({});
    const auto has = [&scene](const std::string& word) {
        return std::count_if(scene.parts.begin(), scene.parts.end(),
                             [&](const std::string& part) { return part.find(word) != std::string::npos; });
    };
    EXPECT_EQ(has(".front"), 5) << "five cars";
    for (const char* part : {"road", "kerb", "barrier", "houses", "debris", "tree", "pole"})
        EXPECT_GE(has(part), 1) << part;
}

TEST(TripodPair, OtherScenesAreOther) {
    TripodPairOptions options = small(8);
    options.sourceScene = TripodSceneOptions{TripodSceneKind::hall, 3};
    EXPECT_FALSE(simulateTripodPair(options).overlaps);
    for (const auto kind : {TripodSceneKind::hall, TripodSceneKind::field, TripodSceneKind::bareRoad}) {
        TripodPairOptions one = small(2);
        one.scene.kind = kind;
        const TripodPair pair = simulateTripodPair(one);
        EXPECT_NEAR(static_cast<double>(pair.source.size()), 8000, 400) << static_cast<int>(kind);
    }
}

TEST(TripodPair, AWrongPoseIsExactlyAsWrongAsAsked) {
    const Pose truth = simulateTripodPair(small(1)).targetFromSource();
    const Pose wrong = wrongPose(truth, 0.5, 4, 11);
    EXPECT_NEAR((wrong.translation() - truth.translation()).norm(), 0.5, 1e-12);
    EXPECT_NEAR(degrees(rotationAngle(truth.linear().transpose() * wrong.linear())), 4, 1e-9);
    EXPECT_NE(wrongPose(truth, 0.5, 4, 12).matrix(), wrong.matrix());
}

}  // namespace
}  // namespace vestige
