#include "core/registration/ndt/TrustRegion.h"

#include <gtest/gtest.h>

namespace vestige {
namespace {

Matrix6d rotatedDiagonal(const Vector6d& values) {
    Matrix6d mixed = Matrix6d::Identity();
    for (int i = 0; i < 5; ++i) {
        Matrix6d turn = Matrix6d::Identity();
        turn(i, i) = turn(i + 1, i + 1) = std::cos(0.4 + i);
        turn(i, i + 1) = -std::sin(0.4 + i);
        turn(i + 1, i) = std::sin(0.4 + i);
        mixed = turn * mixed;
    }
    return mixed * values.asDiagonal() * mixed.transpose();
}

double modelDecrease(const Vector6d& g, const Matrix6d& h, const Vector6d& step) {
    return -(g.dot(step) + 0.5 * step.dot(h * step));
}

/// No step on or inside the bound lowers the model (damped by lambda) further, as far as many directions
/// tell.
void expectMinimiser(const Vector6d& g, const Matrix6d& h, double bound, const TrustRegionStep& found) {
    EXPECT_LE(found.step.norm(), bound * (1 + 1e-9));
    EXPECT_NEAR(found.predictedDecrease, modelDecrease(g, h, found.step), 1e-9 * found.predictedDecrease);
    for (int i = 0; i < 6; ++i)
        for (const double sign : {-1.0, 1.0})
            for (const double size : {1e-4, 1e-2, 0.5}) {
                Vector6d other = found.step + sign * size * bound * Vector6d::Unit(i);
                if (other.norm() > bound) other *= bound / other.norm();
                EXPECT_GE(found.predictedDecrease * (1 + 1e-7), modelDecrease(g, h, other));
            }
}

TEST(TrustRegion, TakesTheNewtonStepInsideTheBound) {
    const Matrix6d h = rotatedDiagonal((Vector6d() << 2, 3, 5, 40, 90, 300).finished());
    const Vector6d g = (Vector6d() << 0.1, -0.2, 0.3, 1, -2, 0.5).finished();
    const TrustRegionStep step = trustRegionStep(g, h, 10, 0.01);
    EXPECT_FALSE(step.bounded);
    const Vector6d newton = -(h + 0.01 * Matrix6d::Identity()).ldlt().solve(g);
    EXPECT_NEAR((step.step - newton).norm(), 0, 1e-12);
}

TEST(TrustRegion, StopsExactlyAtTheBound) {
    const Matrix6d h = rotatedDiagonal((Vector6d() << 2, 3, 5, 40, 90, 300).finished());
    const Vector6d g = (Vector6d() << 5, -2, 3, 10, -2, 0.5).finished();
    const TrustRegionStep step = trustRegionStep(g, h, 0.1, 0.01);
    EXPECT_TRUE(step.bounded);
    EXPECT_NEAR(step.step.norm(), 0.1, 1e-12);
    expectMinimiser(g, h, 0.1, step);
}

TEST(TrustRegion, GoesDownhillWhereTheHessianIsIndefinite) {
    const Matrix6d h = rotatedDiagonal((Vector6d() << -30, -1, 0, 4, 9, 30).finished());
    const Vector6d g = (Vector6d() << 1, 2, -1, 0.5, 0.1, -0.7).finished();
    const TrustRegionStep step = trustRegionStep(g, h, 0.3, 0.01);
    EXPECT_TRUE(step.bounded);
    EXPECT_NEAR(step.step.norm(), 0.3, 1e-9);
    EXPECT_GT(step.predictedDecrease, 0);
    expectMinimiser(g, h, 0.3, step);
}

TEST(TrustRegion, HardCaseUsesTheNegativeCurvature) {
    const Matrix6d h = (Vector6d() << -10, 1, 2, 3, 4, 5).finished().asDiagonal();
    const Vector6d g = (Vector6d() << 0, 0.1, 0.1, 0.1, 0.1, 0.1).finished();
    const TrustRegionStep step = trustRegionStep(g, h, 1, 0.01);
    EXPECT_NEAR(step.step.norm(), 1, 1e-9);
    EXPECT_GT(std::abs(step.step[0]), 0.9);
}

/// A score without points: f of the translation alone.
ScoredPose bowl(const Pose& pose) {
    const Eigen::Vector3d d = pose.translation() - Eigen::Vector3d(1, -2, 0.5);
    ScoredPose scored;
    scored.inside = 1;
    scored.score = -std::exp(-0.5 * d.squaredNorm());
    scored.gradient.head<3>() = -scored.score * d;
    scored.hessian.topLeftCorner<3, 3>() = -scored.score * (Eigen::Matrix3d::Identity() - d * d.transpose());
    return scored;
}

TEST(TrustRegion, FindsTheMinimumFromWhereTheHessianIsIndefinite) {
    TrustRegionOptions options;
    const TrustRegionOutcome outcome = minimise(bowl, Pose::Identity(), 1, options);
    EXPECT_NE(outcome.stop, StopReason::iterationLimit);
    EXPECT_NEAR((outcome.pose.translation() - Eigen::Vector3d(1, -2, 0.5)).norm(), 0, 1e-5);
}

TEST(TrustRegion, SaysWhyItStopped) {
    TrustRegionOptions options;
    options.iterationLimit = 3;
    EXPECT_EQ(minimise(bowl, Pose::Identity(), 1, options).stop, StopReason::iterationLimit);
    const auto nothing = [](const Pose&) { return ScoredPose{}; };
    EXPECT_EQ(minimise(nothing, Pose::Identity(), 1, options).stop, StopReason::noOverlap);
    Pose there = Pose::Identity();
    there.translation() << 1, -2, 0.5;
    EXPECT_EQ(minimise(bowl, there, 1, options).stop, StopReason::gradient);
}

}  // namespace
}  // namespace vestige
