#include <gtest/gtest.h>

#include <cmath>

#include "core/base/AtomicFile.h"
#include "core/base/Numbers.h"
#include "core/base/Random.h"
#include "core/evaluation/SequenceEvaluation.h"
#include "core/evaluation/SequenceFiles.h"
#include "core/evaluation/Trajectory.h"
#include "core/filters/Preprocess.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/registration/Register.h"
#include "tests/support/TestPaths.h"

namespace vestige {
namespace {

Pose pose(double x, double y, double yaw) {
    Pose made = Pose::Identity();
    made.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    made.translation() << x, y, 0;
    return made;
}

/// A room of 6 x 4 x 2.5 m with a box in it, as seen from `worldFromScanner` (no occlusion).
PointCloud room(const Pose& worldFromScanner, std::uint64_t seed) {
    Random random(seed);
    PointCloudBuilder builder;
    const auto sides = [&](const Eigen::Vector3d& min, const Eigen::Vector3d& size, int count) {
        for (int i = 0; i < count; ++i) {
            Eigen::Vector3d at(random.uniform(), random.uniform(), random.uniform());
            at[static_cast<int>(random.below(3))] = random.below(2) == 0 ? 0 : 1;
            const Eigen::Vector3d noise(random.normal(0, 0.003), random.normal(0, 0.003),
                                        random.normal(0, 0.003));
            builder.add(worldFromScanner.inverse() * (min + at.cwiseProduct(size) + noise));
        }
    };
    sides({-3, -2, 0}, {6, 4, 2.5}, 20000);
    sides({0.5, 0.4, 0}, {0.8, 0.5, 1.1}, 3000);
    return std::move(builder).build();
}

std::vector<Pose> walk() {
    return {pose(0, 0, 0), pose(0.15, 0.05, 0.05), pose(0.3, 0.02, 0.12), pose(0.4, -0.1, 0.1)};
}

TEST(RelativePoseError, IsZeroForTheTruthInAnyFrameAndTheRootMeanSquareOtherwise) {
    const std::vector<Pose> truth = walk();
    std::vector<Pose> moved;
    for (const Pose& one : truth) moved.push_back(pose(100, 50, 2) * one);
    const auto none = relativePoseError(moved, truth);
    ASSERT_TRUE(none);
    EXPECT_LT(none->translation_m, 1e-12);
    EXPECT_EQ(none->pairs, 3U);
    // The second step 0.3 m too long, the third 0.4 m: the errors add where the chain goes on.
    std::vector<Pose> wrong = truth;
    wrong[2] = truth[1] * pose(0.3, 0, 0) * truth[1].inverse() * truth[2];
    wrong[3] = wrong[2] * truth[2].inverse() * truth[3];
    const auto some = relativePoseError(wrong, truth);
    ASSERT_TRUE(some);
    EXPECT_NEAR(some->translation_m, 0.3 / std::sqrt(3.0), 1e-9);
    EXPECT_LT(some->rotation_rad, 1e-7);
    EXPECT_FALSE(relativePoseError(truth, std::span(truth).first(3)));
    EXPECT_FALSE(relativePoseError(truth, truth, 4));
}

TEST(Trajectory, ReadsBothLayoutsAndNamesTheLine) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(
        writeTextFile(folder / "asl.csv",
                      "poseId, timestamp, T00, T01, T02, T03, T10, T11, T12, T13, T20, T21, T22, T23, "
                      "T30, T31, T32, T33\n0,1.5,1,0,0,2,0,1,0,3,0,0,1,4,0,0,0,1\n"
                      "1,2.5,0,-1,0,5,1,0,0,6,0,0,1,7,0,0,0,1\n"));
    const auto asl = readTrajectory(folder / "asl.csv");
    ASSERT_TRUE(asl) << asl.error().sentence();
    EXPECT_EQ(asl->at(1).translation(), Eigen::Vector3d(5, 6, 7));
    EXPECT_NEAR(asl->at(1).linear()(1, 0), 1, 1e-12);
    ASSERT_TRUE(writeTextFile(folder / "lines.txt", "# t x y z q\n0 1 2 3 0 0 0 1\n1 4 5 6 0 0 1 0\n"));
    const auto lines = readTrajectory(folder / "lines.txt");
    ASSERT_TRUE(lines) << lines.error().sentence();
    EXPECT_NEAR(lines->at(1).linear()(0, 0), -1, 1e-12);
    ASSERT_TRUE(writeTextFile(folder / "bad.txt", "0 1 2 3 0 0 0 1\n1 4 5 6 0 0 1\n"));
    const auto bad = readTrajectory(folder / "bad.txt");
    ASSERT_FALSE(bad);
    EXPECT_NE(bad.error().sentence().find("line 2"), std::string::npos);
}

TEST(SequenceFiles, AreInNaturalOrder) {
    EXPECT_TRUE(naturallyBefore("Hokuyo_2.csv", "Hokuyo_10.csv"));
    EXPECT_FALSE(naturallyBefore("Hokuyo_10.csv", "Hokuyo_2.csv"));
    EXPECT_TRUE(naturallyBefore("a", "b"));
    EXPECT_FALSE(naturallyBefore("a7", "a7"));
}

TEST(SequenceEvaluation, ChainsThePosesOfASequence) {
    Sequence sequence;
    sequence.truth = walk();
    for (std::size_t i = 0; i < sequence.truth.size(); ++i)
        sequence.clouds.push_back(room(sequence.truth[i], i + 1));
    const auto score = evaluateSequence(sequence, ParameterSet(preprocessParameters()),
                                        ParameterSet(registrationParameters()));
    ASSERT_TRUE(score) << score.error().sentence();
    EXPECT_EQ(score->failed, 0U);
    EXPECT_EQ(score->error.pairs, 3U);
    EXPECT_LT(score->error.translation_m, 0.005);
    EXPECT_GT(score->error.translation_m, 0);
    EXPECT_NE(sequenceCsv({*score}).find("improved-ndt,,"), std::string::npos);
}

TEST(SequenceEvaluation, ReadsAFolderOfClouds) {
    const test::TemporaryFolder folder;
    std::string poses = "poseId,timestamp,T00,T01,T02,T03,T10,T11,T12,T13,T20,T21,T22,T23,T30,T31,T32,T33\n";
    for (std::size_t i = 0; i < 3; ++i) {
        std::string text = "Time_in_sec,x,y,z,Intensities,2DscanId,PointId\n";
        const PointCloud cloud = room(Pose::Identity(), i + 1);
        for (std::size_t k = 0; k < 50; ++k) {
            const Eigen::Vector3d p = cloud.point(k);
            text += "0," + exactText(p.x()) + "," + exactText(p.y()) + "," + exactText(p.z()) + ",1,0,0\n";
        }
        ASSERT_TRUE(writeTextFile(folder / ("Hokuyo_" + std::to_string(9 + i) + ".csv"), text));
        poses += std::to_string(i) + ",0";
        for (const double value : rowMajor(walk()[i])) poses += "," + exactText(value);
        poses += "\n";
    }
    ASSERT_TRUE(writeTextFile(folder / "pose_scanner_leica.csv", poses));
    const auto sequence = readSequence(folder.path(), folder / "pose_scanner_leica.csv");
    ASSERT_TRUE(sequence) << sequence.error().sentence();
    ASSERT_EQ(sequence->clouds.size(), 3U);
    EXPECT_EQ(sequence->clouds[0].size(), 50U);
    EXPECT_LT((sequence->clouds[0].point(0) - room(Pose::Identity(), 1).point(0)).norm(), 1e-6);
    EXPECT_LT((sequence->truth[1].matrix() - walk()[1].matrix()).norm(), 1e-9);
}

}  // namespace
}  // namespace vestige
