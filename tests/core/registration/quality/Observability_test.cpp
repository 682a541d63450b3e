#include "core/registration/quality/Observability.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include "core/base/Random.h"
#include "core/registration/quality/DirectionWords.h"
#include "core/registration/quality/SurfaceFit.h"

namespace vestige {
namespace {

/// Points on squares of 8 m through the origin across each of the `axes`, 3 mm of noise.
std::vector<Eigen::Vector3f> squares(std::initializer_list<int> axes, std::uint64_t seed) {
    Random random(seed);
    std::vector<Eigen::Vector3f> points;
    for (const int axis : axes)
        for (int i = 0; i < 20000; ++i) {
            Eigen::Vector3d point(random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4));
            point[axis] = random.normal(0, 0.003);
            points.push_back(point.cast<float>());
        }
    return points;
}

std::vector<ObservedDirection> directionsOf(std::initializer_list<int> axes) {
    const SurfaceFit fit(squares(axes, 1), squares(axes, 2), 4);
    const PoseInformation information = fit.information(Pose::Identity());
    return observedDirections(information, information.covariance(), 0.1);
}

int freeOf(const std::vector<ObservedDirection>& directions) {
    int free = 0;
    for (const ObservedDirection& one : directions) free += one.free;
    return free;
}

}  // namespace

TEST(Observability, APlaneLetsASlideTwoWaysAndATurn) {
    const auto directions = directionsOf({2});
    ASSERT_EQ(freeOf(directions), 3);
    EXPECT_EQ(directions[0].words.substr(0, 12), "slides level");
    EXPECT_EQ(directions[1].words.substr(0, 12), "slides level");
    EXPECT_EQ(directions[2].words, "turns about the vertical axis");
    for (int i = 0; i < 3; ++i) EXPECT_GT(directions[static_cast<std::size_t>(i)].sigma_m, 1) << i;
    for (int i = 3; i < 6; ++i) EXPECT_LT(directions[static_cast<std::size_t>(i)].sigma_m, 0.003) << i;
    EXPECT_LT(std::abs(directions[0].direction.z()), 0.05);
}

TEST(Observability, AStraightGutterLetsASlideAlongItOnly) {
    const auto directions = directionsOf({1, 2});
    ASSERT_EQ(freeOf(directions), 1);
    EXPECT_EQ(directions[0].words, "slides level roughly east-west (90\u00b0 from the y axis)");
    EXPECT_GT(std::abs(directions[0].direction.x()), 0.99);
}

TEST(Observability, ACornerHoldsEverything) {
    const auto directions = directionsOf({0, 1, 2});
    EXPECT_EQ(freeOf(directions), 0);
    for (std::size_t i = 1; i < directions.size(); ++i)
        EXPECT_LE(directions[i - 1].information, directions[i].information);
}

TEST(Observability, ADirectionIsFreeByTheCovarianceWhereTheHessianHoldsItBetterThanAnother) {
    PoseInformation information;
    information.hessian = Eigen::DiagonalMatrix<double, 6>(1e4, 2e4, 3e4, 4e4, 5e4, 6e4);
    Matrix6d covariance = Matrix6d::Identity() * 0.01 * 0.01;
    covariance(0, 0) = 0.05 * 0.05;
    covariance(1, 1) = 0.5 * 0.5;
    const auto directions = observedDirections(information, covariance, 0.1);
    ASSERT_EQ(freeOf(directions), 1);
    EXPECT_TRUE(directions[0].free);
    EXPECT_NEAR(std::abs(directions[0].direction[1]), 1, 1e-9);
    EXPECT_NEAR(directions[1].sigma_m, 0.05, 1e-9);
}

TEST(Observability, OnePieceOfSurfaceIsNoEvidence) {
    SurfaceCell cell;
    cell.normal = Eigen::Vector3d::UnitZ();
    cell.wide = Eigen::Vector3d::UnitX();
    cell.mean.setZero();
    cell.area_m2 = cell.wide_m = cell.narrow_m = cell.size_m = 1;
    cell.count = 100;
    SurfaceMatch match;
    match.other = &cell;
    match.normal = cell.normal;
    match.state = SurfaceState::agrees;
    const std::vector<SurfaceMatch> matches{match};
    const PoseInformation information = poseInformation(matches, {cell}, 1);
    EXPECT_EQ(information.weight, 0);
    EXPECT_TRUE(information.covariance().allFinite());
}

TEST(Observability, WordsForMotions) {
    Vector6d motion = Vector6d::Zero();
    motion[2] = -1;
    EXPECT_EQ(motionWords(motion), "moves up and down");
    motion << 0, -2, 0, 0, 0, 0;
    EXPECT_EQ(motionWords(motion), "slides level roughly north-south (0\u00b0 from the y axis)");
    motion << 0, 0, 0, 0, 0, 3;
    EXPECT_EQ(motionWords(motion), "turns about the vertical axis");
    motion << 0, 0, 0, 1, 0, 0;
    EXPECT_EQ(motionWords(motion),
              "tilts about a level axis that runs roughly east-west (90\u00b0 from the y axis)");
}

TEST(Observability, TheSpreadOfACornersFitsIsWhatItsCovarianceSays) {
    // Over draws of both clouds' noise; the truth is the identity.
    constexpr int kDraws = 12;
    double squared = 0;
    for (std::uint64_t i = 0; i < kDraws; ++i) {
        const SurfaceFit fit(squares({0, 1, 2}, 100 + 2 * i), squares({0, 1, 2}, 101 + 2 * i), 4);
        const Pose refined = fit.refined(Pose::Identity());
        const PoseInformation information = fit.information(refined);
        const Vector6d error =
            stepBetween(refined, Pose::Identity(), information.pivot_m, information.radius_m);
        squared += error.dot(information.covariance().ldlt().solve(error)) / 6;
    }
    EXPECT_GT(squared / kDraws, 0.2);
    EXPECT_LT(squared / kDraws, 2.5);
}

TEST(PoseInformation, StaysPositiveDefiniteBesideADirectionThatNothingHolds) {
    Random random(3);
    Matrix6d axes;
    for (double& value : axes.reshaped()) value = random.normal();
    const Matrix6d turn = Eigen::HouseholderQR<Matrix6d>(axes).householderQ();
    Vector6d strength;
    strength << 1e-3, 3e6, 1e7, 5e7, 2e8, 2e9;
    PoseInformation information;
    information.radius_m = 18;
    information.hessian = turn * strength.asDiagonal() * turn.transpose();
    information.noise = 1e-2 * Matrix6d::Identity();
    information.scatter = 1e7 * Matrix6d::Identity();
    const Matrix6d covariance = information.covariance();
    const Eigen::SelfAdjointEigenSolver<Matrix6d> solver(covariance);
    EXPECT_EQ((covariance - covariance.transpose()).norm(), 0);
    EXPECT_NEAR(std::sqrt(solver.eigenvalues()[5]), 18, 1e-6) << "one radius where nothing holds it";
    for (int i = 0; i < 5; ++i) {
        const double expected = 1e7 / (strength[5 - i] * strength[5 - i]);
        EXPECT_NEAR(solver.eigenvalues()[i] / expected, 1, 0.01) << i;
    }
}

}  // namespace vestige
