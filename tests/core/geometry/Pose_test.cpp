#include "core/geometry/Pose.h"

#include <gtest/gtest.h>

using namespace vestige;

TEST(Pose, RowMajorRoundTripKeepsEveryBit) {
    Pose pose = Pose::Identity();
    pose.linear() = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
    pose.translation() = Eigen::Vector3d(1e6, -0.1, 3);
    EXPECT_EQ(poseFromRowMajor(rowMajor(pose)).value().matrix(), pose.matrix());
}

TEST(Pose, RefusesScaleMirrorAndProjection) {
    auto values = rowMajor(Pose::Identity());
    values[0] = 0.001;
    EXPECT_FALSE(poseFromRowMajor(values));
    values[0] = -1;
    EXPECT_FALSE(poseFromRowMajor(values));
    values[0] = 1;
    values[12] = 1;
    EXPECT_FALSE(poseFromRowMajor(values));
}

TEST(Pose, SmallAnglesAreNotLost) {
    const Eigen::Matrix3d tiny = Eigen::AngleAxisd(1e-9, Eigen::Vector3d::UnitY()).toRotationMatrix();
    EXPECT_NEAR(rotationAngle(tiny), 1e-9, 1e-15);
}

TEST(Similarity, InverseUndoesIt) {
    Similarity move;
    move.scale = 0.001;
    move.pose = Eigen::Translation3d(5, 6, 7) * Eigen::AngleAxisd(2, Eigen::Vector3d::UnitX());
    const Eigen::Vector3d x(100, -2000, 30);
    EXPECT_LT((move.inverse() * (move * x) - x).norm(), 1e-9);
    EXPECT_LT(((move * move.inverse()) * x - x).norm(), 1e-9);
}
