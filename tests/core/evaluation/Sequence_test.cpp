#include "core/evaluation/Sequence.h"

#include <gtest/gtest.h>

#include "core/base/AtomicFile.h"
#include "core/base/Numbers.h"
#include "core/evaluation/SequenceFiles.h"
#include "core/evaluation/Trajectory.h"
#include "core/io/FormatRegistry.h"
#include "tests/core/evaluation/EvaluationClouds.h"
#include "tests/support/TestPaths.h"

namespace vestige {
namespace {

using test::walk;

constexpr const char* kPoseHeader =
    "poseId,timestamp,T00,T01,T02,T03,T10,T11,T12,T13,T20,T21,T22,T23,T30,T31,T32,T33\n";

std::string poseRow(int id, const Pose& pose) {
    std::string text = std::to_string(id) + ",0.5";
    for (const double value : rowMajor(pose)) text += "," + exactText(value);
    return text + "\n";
}

std::string aslCloud(const PointCloud& cloud, const Pose& frame, std::size_t count) {
    std::string text = "Time_in_sec,x,y,z,Intensities,2DscanId,PointId\n";
    for (std::size_t k = 0; k < count; ++k) {
        const Eigen::Vector3d p = frame * cloud.point(k);
        text += "0.25," + exactText(p.x()) + "," + exactText(p.y()) + "," + exactText(p.z()) + ",1,0,0\n";
    }
    return text;
}

/// A folder in the ASL layout: clouds 9, 10, 11 and their poses.
class AslFolder : public testing::Test {
  protected:
    void SetUp() override {
        std::string poses = kPoseHeader;
        for (int i = 0; i < 3; ++i) {
            const Pose pose = walk()[static_cast<std::size_t>(i)];
            clouds_.push_back(test::room(pose, static_cast<std::uint64_t>(i + 1)));
            write("Hokuyo_" + std::to_string(9 + i) + ".csv", aslCloud(clouds_.back(), Pose::Identity(), 50));
            poses += poseRow(i, pose);
        }
        write("pose_scanner_leica.csv", poses);
    }
    void write(const std::string& name, const std::string& text) const {
        ASSERT_TRUE(writeTextFile(folder_ / name, text));
    }
    std::filesystem::path truth() const { return folder_ / "pose_scanner_leica.csv"; }
    Result<Sequence> read() const { return readSequence(folder_.path(), truth()); }
    std::string sentence() const {
        const auto sequence = read();
        EXPECT_FALSE(sequence);
        return sequence ? std::string() : sequence.error().sentence();
    }
    void expectWhole(const Result<Sequence>& sequence) const {
        ASSERT_TRUE(sequence) << sequence.error().sentence();
        ASSERT_EQ(sequence->clouds.size(), 3U);
        for (std::size_t i = 0; i < 3; ++i) {
            ASSERT_EQ(sequence->clouds[i].size(), 50U);
            for (std::size_t k = 0; k < 50; ++k)
                EXPECT_LT((sequence->clouds[i].point(k) - clouds_[i].point(k)).norm(), 1e-6);
            EXPECT_LT((sequence->truth[i].matrix() - walk()[i].matrix()).norm(), 1e-9);
        }
    }

    test::TemporaryFolder folder_;
    std::vector<PointCloud> clouds_;
};

TEST_F(AslFolder, IsReadInTheOrderOfItsNumbers) {
    expectWhole(read());
    EXPECT_FLOAT_EQ(static_cast<float>(read()->clouds[0].attributes().gpsTime[0]), 0.25F);
    const SequenceExtent extent = extentOf(*read());
    EXPECT_EQ(extent.points, 150U);
    EXPECT_NEAR(extent.path_m, std::hypot(0.15, 0.05) + std::hypot(0.15, 0.03), 1e-9);
    EXPECT_NEAR(extent.largestTurn_rad, 0.07, 1e-9);
}

TEST_F(AslFolder, WithCloudsInTheWorldFrameIsBroughtToTheScanners) {
    for (int i = 0; i < 3; ++i) {
        std::filesystem::remove(folder_ / ("Hokuyo_" + std::to_string(9 + i) + ".csv"));
        write("PointCloud" + std::to_string(9 + i) + ".csv",
              aslCloud(clouds_[static_cast<std::size_t>(i)], walk()[static_cast<std::size_t>(i)], 50));
    }
    expectWhole(read());
    const auto asTheyAre = readSequence(folder_.path(), truth(), SequenceFrame::scanner);
    ASSERT_TRUE(asTheyAre);
    EXPECT_LT((asTheyAre->clouds[2].point(7) - walk()[2] * clouds_[2].point(7)).norm(), 1e-6);
}

TEST_F(AslFolder, WhosePosesStandInAnotherOrderIsPairedByNumber) {
    write("pose_scanner_leica.csv",
          kPoseHeader + poseRow(11, walk()[2]) + poseRow(9, walk()[0]) + poseRow(10, walk()[1]));
    expectWhole(read());
}

TEST_F(AslFolder, ThatIsBrokenIsRefusedWithASentence) {
    write("pose_scanner_leica.csv", kPoseHeader + poseRow(0, walk()[0]) + poseRow(1, walk()[1]));
    EXPECT_NE(sentence().find("2 poses for 3 clouds"), std::string::npos) << sentence();
    write("pose_scanner_leica.csv",
          kPoseHeader + poseRow(0, walk()[0]) + poseRow(1, walk()[1]) + poseRow(7, walk()[2]));
    EXPECT_NE(sentence().find("Hokuyo_11.csv"), std::string::npos) << sentence();
    write("pose_scanner_leica.csv",
          kPoseHeader + poseRow(0, walk()[0]) + poseRow(1, walk()[1]) + poseRow(1, walk()[2]));
    EXPECT_NE(sentence().find("line 4: poseId 1 is there twice"), std::string::npos) << sentence();
    std::string nan = poseRow(2, walk()[2]);
    nan.replace(nan.find(",0.5,") + 5, 3, "nan");
    write("pose_scanner_leica.csv", kPoseHeader + poseRow(0, walk()[0]) + poseRow(1, walk()[1]) + nan);
    EXPECT_NE(sentence().find("line 4: 'nan"), std::string::npos) << sentence();
    std::string header = kPoseHeader;
    header.erase(header.find(",T13"), 4);
    write("pose_scanner_leica.csv", header + poseRow(0, walk()[0]));
    EXPECT_NE(sentence().find("line 1: the header has no column T13"), std::string::npos) << sentence();
    write("pose_scanner_leica.csv", kPoseHeader + std::string("0,0.5,2,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1\n"));
    EXPECT_NE(sentence().find("line 2"), std::string::npos) << sentence();
}

TEST_F(AslFolder, WithABrokenCloudNamesFileAndLine) {
    write("Hokuyo_10.csv", "Time_in_sec,x,y,Intensities,2DscanId,PointId\n0,1,2,3,4,5\n");
    EXPECT_NE(sentence().find("Hokuyo_10.csv"), std::string::npos) << sentence();
    write("Hokuyo_10.csv", "Time_in_sec,x,y,z,Intensities,2DscanId,PointId\n0,1,2,3,4,5,6\n0,1,2,3\n");
    EXPECT_NE(sentence().find("Hokuyo_10.csv"), std::string::npos) << sentence();
    EXPECT_NE(sentence().find("3"), std::string::npos) << sentence();
}

TEST(SequenceFolder, OfAnyReadableFormatTakesLinesOfQuaternions) {
    const test::TemporaryFolder folder;
    std::string lines = "# t x y z qx qy qz qw\n";
    for (std::size_t i = 0; i < 3; ++i) {
        const Pose pose = walk()[i];
        const TriangleMesh cloud{test::room(pose, i + 1), {}};
        ASSERT_TRUE(writeGeometry(folder / ("scan " + std::to_string(8 + i) + ".ply"), cloud));
        const Eigen::Quaterniond turn(pose.linear());
        lines += std::to_string(i);
        for (const double value : {pose.translation().x(), pose.translation().y(), pose.translation().z(),
                                   turn.x(), turn.y(), turn.z(), turn.w()})
            lines += " " + exactText(value);
        lines += "\n";
    }
    ASSERT_TRUE(writeTextFile(folder / "poses.txt", lines));
    // Neither the poses nor what lies beside the clouds is one.
    ASSERT_TRUE(writeTextFile(folder / "remarks.txt", "taken in the rain\n"));
    for (const char* name : {"a.json", "b.json", "c.json", "d.json"})
        ASSERT_TRUE(writeTextFile(folder / name, R"({"pose":[1,0,0,0]})"));
    const auto sequence = readSequence(folder.path(), folder / "poses.txt");
    ASSERT_TRUE(sequence) << sequence.error().sentence();
    ASSERT_EQ(sequence->clouds.size(), 3U);
    EXPECT_LT((sequence->clouds[2].point(5) - test::room(walk()[2], 3).point(5)).norm(), 1e-6);
    EXPECT_LT((sequence->truth[1].matrix() - walk()[1].matrix()).norm(), 1e-12);
}

TEST(SequenceFolder, WithoutTwoCloudsIsRefused) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeTextFile(folder / "poses.txt", "0 1 2 3 0 0 0 1\n1 4 5 6 0 0 1 0\n"));
    ASSERT_FALSE(readSequence(folder.path(), folder / "poses.txt"));
    ASSERT_FALSE(readSequence(folder / "absent", folder / "poses.txt"));
    ASSERT_FALSE(readSequence(folder.path(), folder / "absent.txt"));
}

TEST(Trajectory, ReadsBothLayoutsAndNamesTheLine) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(
        writeTextFile(folder / "asl.csv",
                      "poseId, timestamp, T00, T01, T02, T03, T10, T11, T12, T13, T20, T21, T22, T23, "
                      "T30, T31, T32, T33\r\n0,1.5,1,0,0,2,0,1,0,3,0,0,1,4,0,0,0,1\r\n"
                      "1,2.5,0,-1,0,5,1,0,0,6,0,0,1,7,0,0,0,1\r\n"));
    const auto asl = readTrajectory(folder / "asl.csv");
    ASSERT_TRUE(asl) << asl.error().sentence();
    EXPECT_EQ(asl->poses.at(1).translation(), Eigen::Vector3d(5, 6, 7));
    EXPECT_NEAR(asl->poses.at(1).linear()(1, 0), 1, 1e-12);
    EXPECT_EQ(asl->ids, (std::vector<std::int64_t>{0, 1}));
    ASSERT_TRUE(writeTextFile(folder / "lines.txt", "# t x y z q\n0 1 2 3 0 0 0 1\n1 4 5 6 0 0 1 0\n"));
    const auto lines = readTrajectory(folder / "lines.txt");
    ASSERT_TRUE(lines) << lines.error().sentence();
    EXPECT_NEAR(lines->poses.at(1).linear()(0, 0), -1, 1e-12);
    EXPECT_TRUE(lines->ids.empty());
    for (const char* text : {"0 1 2 3 0 0 0 1\n1 4 5 6 0 0 1\n", "0 1 2 3 0 0 0 1\n1 4 5 6 0 0 1 1\n",
                             "0 1 2 3 0 0 0 1\n1 4 x 6 0 0 0 1\n"}) {
        ASSERT_TRUE(writeTextFile(folder / "bad.txt", text));
        const auto bad = readTrajectory(folder / "bad.txt");
        ASSERT_FALSE(bad);
        EXPECT_NE(bad.error().sentence().find("line 2"), std::string::npos);
    }
}

TEST(SequenceFiles, AreInNaturalOrder) {
    EXPECT_TRUE(naturallyBefore("Hokuyo_2.csv", "Hokuyo_10.csv"));
    EXPECT_FALSE(naturallyBefore("Hokuyo_10.csv", "Hokuyo_2.csv"));
    EXPECT_TRUE(naturallyBefore("a", "b"));
    EXPECT_FALSE(naturallyBefore("a7", "a7"));
}

}  // namespace
}  // namespace vestige
