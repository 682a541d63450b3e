#include "core/registration/Register.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Parallel.h"
#include "core/base/Random.h"
#include "core/base/Units.h"
#include "core/geometry/PointCloudBuilder.h"
#include "tests/core/registration/StreetScene.h"

namespace vestige {
namespace {

using test::distanceAt;
using test::scanStreet;
using test::turnBetween;

Pose station(double x, double y, double yawDegrees) {
    Pose pose = Pose::Identity();
    pose.linear() = Eigen::AngleAxisd(radians(yawDegrees), Eigen::Vector3d::UnitZ()).toRotationMatrix();
    pose.translation() << x, y, 1.8;
    return pose;
}

Pose disturbed(const Pose& pose, double metres, double degrees, std::uint64_t seed) {
    Random random(seed);
    const Eigen::Vector3d axis =
        Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
    const Eigen::Vector3d shift =
        Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
    Pose start = pose;
    start.linear() = Eigen::AngleAxisd(radians(degrees), axis).toRotationMatrix() * pose.linear();
    start.translation() += metres * shift;
    return start;
}

struct StreetPair {
    TriangleMesh target{scanStreet({station(0, 0, 0), 0.003, 64, 900, 1}), {}};
    TriangleMesh source{scanStreet({station(9, 1.5, 25), 0.003, 64, 900, 2}), {}};
    Pose truth = station(0, 0, 0).inverse() * station(9, 1.5, 25);
};
const StreetPair& street() {
    static const StreetPair pair;
    return pair;
}

Result<RegistrationResult> registered(const TriangleMesh& target, const TriangleMesh& source,
                                      const Similarity& initial) {
    return registerGeometry(target, source, initial, ParameterSet(registrationParameters()));
}

TEST(Register, FindsAKnownPoseFromAMetreAndFifteenDegreesAway) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        const auto result =
            registered(street().target, street().source, {disturbed(street().truth, 1, 15, seed), 1});
        ASSERT_TRUE(result) << result.error().sentence();
        EXPECT_TRUE(result->converged);
        EXPECT_LT(distanceAt(result->targetFromSource.pose, street().truth, {0, 0, 0}), 0.005);
        EXPECT_LT(turnBetween(result->targetFromSource.pose, street().truth), 0.03);
        EXPECT_GT(result->overlap, 0.5);
        EXPECT_LT(result->rmse_m, 0.5 * result->inlierDistance_m);
        EXPECT_EQ(result->voxelSchedule_m.size(), result->levels.size());
    }
}

TEST(Register, AFitThatLeavesAKnownFirstPoseIsNotTrusted) {
    ParameterSet parameters{registrationParameters()};
    ASSERT_TRUE(parameters.set("start_error_m", 0.02));
    ASSERT_TRUE(parameters.set("voxel_start_m", 4.0));
    ASSERT_TRUE(parameters.set("voxel_m", 1.0));
    Similarity far{street().truth, 1};
    far.pose.linear() = Eigen::AngleAxisd(radians(20), Eigen::Vector3d::UnitZ()) * far.pose.linear();
    const auto attempt = attemptRegistration(street().target, street().source, far, parameters);
    ASSERT_TRUE(attempt) << attempt.error().sentence();
    EXPECT_FALSE(attempt->trustworthy());
    EXPECT_EQ(registerGeometry(street().target, street().source, far, parameters).error().code,
              ErrorCode::untrustworthy);
    const Similarity near{disturbed(street().truth, 0.02, 0.2, 5), 1};
    const auto kept = registerGeometry(street().target, street().source, near, parameters);
    ASSERT_TRUE(kept) << kept.error().sentence();
    EXPECT_LT(distanceAt(kept->targetFromSource.pose, street().truth, {0, 0, 0}), 0.01);
}

TEST(Register, StaysAtTheTruth) {
    const auto result = registered(street().target, street().source, {street().truth, 1});
    ASSERT_TRUE(result);
    EXPECT_LT(distanceAt(result->targetFromSource.pose, street().truth, {0, 0, 0}), 0.005);
}

TEST(Register, IsTheSameBitsForAnyThreadCount) {
    const Similarity start{disturbed(street().truth, 0.5, 5, 4), 1};
    setThreadCount(1);
    const auto one = registered(street().target, street().source, start);
    ASSERT_TRUE(one);
    for (const int threads : {2, 7}) {
        setThreadCount(threads);
        const auto many = registered(street().target, street().source, start);
        ASSERT_TRUE(many);
        EXPECT_EQ(one->targetFromSource.pose.matrix(), many->targetFromSource.pose.matrix());
        EXPECT_EQ(one->rmse_m, many->rmse_m);
        EXPECT_EQ(one->overlap, many->overlap);
        EXPECT_EQ(one->iterations, many->iterations);
    }
    setThreadCount(0);
}

TEST(Register, DoesNotDependOnTheOriginOrTheMagnitude) {
    const Similarity start{disturbed(street().truth, 0.3, 3, 5), 1};
    const auto near = registered(street().target, street().source, start);
    Pose utm = Pose::Identity();
    utm.translation() << 448262, 5411932, 112;
    const auto far = registered(street().target.transformed({utm, 1}), street().source.transformed({utm, 1}),
                                {utm * start.pose * utm.inverse(), 1});
    ASSERT_TRUE(near && far);
    const Pose back = utm.inverse() * far->targetFromSource.pose * utm;
    EXPECT_LT(distanceAt(back, near->targetFromSource.pose, {10, 10, 0}), 1e-4);
}

TEST(Register, TheRotationIsExactlyOrthonormal) {
    const auto result = registered(street().target, street().source, {street().truth, 1});
    ASSERT_TRUE(result);
    const Eigen::Matrix3d r = result->targetFromSource.pose.linear();
    EXPECT_LT((r * r.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(Register, AHandheldScanInMillimetresOnANoisyScene) {
    // The front of a car in its own frame, on an aerial cloud of 30 mm noise, from picked points.
    const PointCloud aerial = test::carSurface(1500, 0.03, 1);
    const PointCloud all = test::carSurface(20000, 0.0001, 2);
    std::vector<std::uint32_t> front;
    for (std::uint32_t i = 0; i < all.size(); ++i)
        if (all.point(i).x() > 0.9) front.push_back(i);
    Pose metresFromHandheld = Pose::Identity();
    metresFromHandheld.linear() =
        Eigen::AngleAxisd(2, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
    metresFromHandheld.translation() << 1, 2, 0.3;
    const Similarity truth{metresFromHandheld, 0.001};
    const PointCloud handheld = all.select(front).transformed(truth.inverse());
    ASSERT_GT(handheld.bounds().diagonal(), 1000);
    const Eigen::Vector3d middle = handheld.bounds().centre() * 0.001;
    Pose start = disturbed(truth.pose, 0.05, 2, 7);
    start.translation() += truth.pose * middle - start * middle;
    // The verdict on it is another matter: of a pose this near some planes agree in few directions.
    const auto result = attemptRegistration({aerial, {}}, {handheld, {}}, {start, 0.001},
                                            ParameterSet(registrationParameters()));
    ASSERT_TRUE(result) << result.error().sentence();
    EXPECT_EQ(result->targetFromSource.scale, 0.001);
    EXPECT_LT(distanceAt(result->targetFromSource.pose, truth.pose, middle), 0.01);
    EXPECT_LT(turnBetween(result->targetFromSource.pose, truth.pose), 0.4);
}

TEST(Register, RefusesCellsThatCannotBeCountedAcrossTheClouds) {
    PointCloudBuilder points;
    for (int i = 0; i < 600; ++i) points.add({static_cast<double>(i), std::sin(i), std::cos(3 * i)});
    const PointCloud road = std::move(points).build();
    for (const char* method : {"improved-ndt", "ndt", "icp"}) {
        ParameterSet parameters(registrationParameters());
        ASSERT_TRUE(parameters.set("method", method));
        ASSERT_TRUE(parameters.set("leaf_m", 0.0001));
        const auto result = attemptRegistration({road, {}}, {road, {}}, {}, parameters);
        ASSERT_FALSE(result) << method;
        EXPECT_EQ(result.error().code, ErrorCode::usage) << method;
    }
}

TEST(Register, SaysWhichParametersAMethodHasNoUseFor) {
    const TriangleMesh car{test::carSurface(2000, 0, 1), {}};
    const auto notesOf = [&](const char* method) {
        ParameterSet parameters(registrationParameters());
        EXPECT_TRUE(parameters.set("method", method));
        EXPECT_TRUE(parameters.set("flatness", 0.02));
        EXPECT_TRUE(parameters.set("restarts", std::int64_t{0}));
        const auto result = attemptRegistration(car, car, {}, parameters);
        std::string text;
        if (result)
            for (const std::string& note : result->notes) text += note + "\n";
        return text;
    };
    EXPECT_NE(notesOf("icp").find("--flatness has no effect"), std::string::npos);
    EXPECT_EQ(notesOf("improved-ndt").find("no effect"), std::string::npos);
}

TEST(Register, ASmallThingNeedsNoOtherParameters) {
    // The same body 0.2 m long.
    const Similarity shrink{Pose::Identity(), 0.2 / 4.5};
    const TriangleMesh target{test::carSurface(2000, 0, 1).transformed(shrink), {}};
    const TriangleMesh source{test::carSurface(2000, 0, 2).transformed(shrink), {}};
    const auto result = registered(target, source, {disturbed(Pose::Identity(), 0.01, 8, 3), 1});
    ASSERT_TRUE(result) << result.error().sentence();
    EXPECT_LT(distanceAt(result->targetFromSource.pose, Pose::Identity(), {0, 0, 0.03}), 0.0005);
    EXPECT_LT(turnBetween(result->targetFromSource.pose, Pose::Identity()), 0.2);
}

TEST(Register, AMeshIsRegisteredByItsSurface) {
    PointCloudBuilder corners;
    std::vector<Triangle> triangles;
    const auto quad = [&](Eigen::Vector3d a, Eigen::Vector3d b, Eigen::Vector3d c, Eigen::Vector3d d) {
        const auto first = static_cast<std::uint32_t>(corners.size());
        for (const auto& corner : {a, b, c, d}) corners.add(corner);
        triangles.push_back({first, first + 1, first + 2});
        triangles.push_back({first, first + 2, first + 3});
    };
    quad({0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0});
    quad({0, 0, 0}, {4, 0, 0}, {4, 0, 2}, {0, 0, 2});
    quad({0, 0, 0}, {0, 3, 0}, {0, 3, 2}, {0, 0, 2});
    const TriangleMesh mesh{std::move(corners).build(), triangles};
    const TriangleMesh cloud{sampleSurface(mesh, 0.02, 5), {}};
    const auto result = registered(cloud, mesh, {disturbed(Pose::Identity(), 0.2, 5, 3), 1});
    ASSERT_TRUE(result) << result.error().sentence();
    EXPECT_LT(distanceAt(result->targetFromSource.pose, Pose::Identity(), {2, 1, 1}), 0.002);
}

TEST(Register, SaysWhenThereIsNothingToHoldOnTo) {
    const auto apart = registered(street().target, street().source, {station(500, 0, 0), 1});
    ASSERT_FALSE(apart);
    EXPECT_EQ(apart.error().code, ErrorCode::untrustworthy);
    EXPECT_FALSE(apart.error().sentence().empty());
    PointCloudBuilder few;
    for (int i = 0; i < 4; ++i) few.add(Eigen::Vector3d(i, i * i, 0));
    const auto tooFew = registered(street().target, {std::move(few).build(), {}}, {});
    ASSERT_FALSE(tooFew);
    EXPECT_EQ(tooFew.error().code, ErrorCode::untrustworthy);
    const auto empty = registered({}, street().source, {});
    ASSERT_FALSE(empty);
    EXPECT_EQ(empty.error().code, ErrorCode::untrustworthy);
}

TEST(Register, TheOptionsOfTheUserAreTaken) {
    ParameterSet parameters(registrationParameters());
    ASSERT_TRUE(parameters.set("voxel_m", 0.5));
    ASSERT_TRUE(parameters.set("voxel_start_m", 2.0));
    const auto result = registerGeometry(street().target, street().source, {street().truth, 1}, parameters);
    ASSERT_TRUE(result);
    EXPECT_DOUBLE_EQ(result->voxelSchedule_m.front(), 2);
    EXPECT_DOUBLE_EQ(result->voxelSchedule_m.back(), 0.5);
    ASSERT_TRUE(parameters.set("preset", std::string("paper")));
    const auto paper = registerGeometry(street().target, street().source, {street().truth, 1}, parameters);
    ASSERT_TRUE(paper) << paper.error().sentence();
    EXPECT_NE(paper->targetFromSource.pose.matrix(), result->targetFromSource.pose.matrix());
}

TEST(Register, StopsWhenCancelled) {
    JobControl control;
    control.cancel();
    const auto result = registerGeometry(street().target, street().source, {street().truth, 1},
                                         ParameterSet(registrationParameters()), control);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace vestige
