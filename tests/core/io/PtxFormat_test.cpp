#include <gtest/gtest.h>

#include <tuple>

#include "core/base/Numbers.h"
#include "tests/core/io/Clouds.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

const std::string kIdentity = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";

std::string refusal(const std::filesystem::path& file, const std::string& content) {
    writeBytes(file, content);
    const Result<LoadedGeometry> loaded = readGeometry(file);
    if (loaded) return "read " + std::to_string(loaded->geometry.vertices.size());
    EXPECT_EQ(loaded.error().code, ErrorCode::input);
    return loaded.error().sentence();
}

bool warnsOf(const FileInfo& info, const std::string& words) {
    return std::any_of(info.warnings.begin(), info.warnings.end(),
                       [&](const auto& warning) { return warning.find(words) != std::string::npos; });
}

}  // namespace

// The values of the real files are those that stand in them, as PDAL's own tests check them too.
TEST(PtxFormat, ReadsOneScanWithColor) {
    VESTIGE_SHARED_OR_SKIP(file, "formats/text/ptx/1.2-with-color.ptx");
    const LoadedGeometry scan = readOrFail(file);
    const PointCloud& cloud = scan.geometry.vertices;
    ASSERT_EQ(cloud.size(), 15 * 71);
    EXPECT_LT((cloud.point(0) - Eigen::Vector3d(637012.24, 849028.31, 431.66)).norm(), 1e-6);
    EXPECT_LT((cloud.point(489) - Eigen::Vector3d(635770.47, 851464.67, 422.28)).norm(), 1e-6);
    EXPECT_EQ(cloud.attributes().intensity[489], 0.019775F);
    EXPECT_EQ(cloud.attributes().color[489], (Color{105 * 257, 85 * 257, 114 * 257}));
    EXPECT_TRUE(cloud.attributes().pointSource.empty());
    ASSERT_EQ(scan.info.scans.size(), 1);
    EXPECT_TRUE(scan.info.scans[0].fileFromScan.isApprox(Pose::Identity()));
    EXPECT_TRUE(scan.info.warnings.empty());
}

TEST(PtxFormat, TransformsRowVectorsAndLeavesOutWhatDidNotReturn) {
    VESTIGE_SHARED_OR_SKIP(file, "formats/text/ptx/complex-transform.ptx");
    const LoadedGeometry scan = readOrFail(file);
    ASSERT_EQ(scan.geometry.vertices.size(), 4);
    EXPECT_LT((scan.geometry.vertices.point(0) - Eigen::Vector3d(-3.034408, -3.173781, -1.823750)).norm(),
              1e-6);
    EXPECT_EQ(scan.geometry.vertices.attributes().color[0], (Color{33 * 257, 38 * 257, 24 * 257}));
    EXPECT_TRUE(warnsOf(scan.info, "8 points without a return"));
    const Pose& pose = scan.info.scans[0].fileFromScan;
    EXPECT_LT((pose.translation() - Eigen::Vector3d(-3.028748, -3.819741, -1.384333)).norm(), 1e-12);
    EXPECT_LT((pose.linear() * pose.linear().transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    // The first point of the file, moved by the pose alone.
    EXPECT_LT(
        (pose * Eigen::Vector3d(-0.005630, 0.645218, -0.440506) - scan.geometry.vertices.point(0)).norm(),
        2e-6);
}

TEST(PtxFormat, KeepsSeveralScansApart) {
    VESTIGE_SHARED_OR_SKIP(file, "formats/text/ptx/multiple-and-transform.ptx");
    const LoadedGeometry both = readOrFail(file);
    const PointCloud& cloud = both.geometry.vertices;
    ASSERT_EQ(cloud.size(), 8);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_LT((cloud.point(i) - cloud.point(i + 4)).norm(), 2e-5)  // what a float offset may lose
            << "the same points, one set transformed";
    EXPECT_EQ(cloud.attributes().pointSource, (std::vector<std::uint16_t>{1, 1, 1, 1, 2, 2, 2, 2}));
    ASSERT_EQ(both.info.scans.size(), 2);
    EXPECT_EQ(both.info.scans[1].name, "scan 2");
    EXPECT_EQ(both.info.scans[0].points, 4);
    EXPECT_TRUE(warnsOf(both.info, "scan 1 scales, shears or mirrors"));  // its z axis is doubled
    EXPECT_EQ(both.info.scans[0].fileFromScan.translation(), Eigen::Vector3d(600000, 800000, 400));
}

TEST(PtxFormat, EqualPointsReadEqualToText) {
    VESTIGE_SHARED_OR_SKIP(file, "formats/text/ptx/no-color.ptx");
    const LoadedGeometry scan = readOrFail(file);
    ASSERT_EQ(scan.geometry.vertices.size(), 15);
    EXPECT_TRUE(scan.geometry.vertices.attributes().color.empty());
    const TemporaryFolder folder;
    std::string text = readBytes(file);
    for (int line = 0; line < 10; ++line) text.erase(0, text.find('\n') + 1);
    writeBytes(folder / "points.xyz", text);
    EXPECT_EQ(largestDifference(readOrFail(folder / "points.xyz").geometry.vertices, scan.geometry.vertices),
              0);
    std::filesystem::copy_file(file, folder / "renamed.txt");  // known by its content
    EXPECT_EQ(readOrFail(folder / "renamed.txt").info.format, "PTX");
}

TEST(PtxFormat, FillsUpWhatOnlySomeScansHave) {
    const TemporaryFolder folder;
    writeBytes(folder / "a.ptx", "1\n2\n" + kIdentity + "1 1 1 0.5\n0 0 0 0.5\n\n2\n1\n" + kIdentity +
                                     "2 2 2 0.25 9 8 7\n0 0 0 0\n1\r\n1\r\n" + kIdentity + "3 3 3\n");
    const LoadedGeometry mixed = readOrFail(folder / "a.ptx");
    const PointAttributes& attributes = mixed.geometry.vertices.attributes();
    ASSERT_EQ(mixed.geometry.vertices.size(), 3);
    EXPECT_EQ(attributes.intensity[0], 0.5F);
    EXPECT_EQ(attributes.intensity[2], 0);
    EXPECT_EQ(attributes.color[0], Color{});
    EXPECT_EQ(attributes.color[1], (Color{9 * 257, 8 * 257, 7 * 257}));
    EXPECT_EQ(attributes.pointSource, (std::vector<std::uint16_t>{1, 2, 3}));
}

TEST(PtxFormat, RefusesWhatIsNone) {
    const TemporaryFolder folder;
    const auto file = folder / "a.ptx";
    const std::string one = "1\n1\n" + kIdentity;
    EXPECT_NE(refusal(file, "4294967295\n4294967295\n" + kIdentity + "1 1 1 1\n").find("room for 1 point"),
              std::string::npos);
    EXPECT_NE(refusal(file, "-1\n1\n" + kIdentity + "1 1 1 1\n").find("line 1"), std::string::npos);
    EXPECT_NE(refusal(file, "1\n1e30\n" + kIdentity + "1 1 1 1\n").find("line 2"), std::string::npos);
    EXPECT_NE(refusal(file, "1\n1\n0 0 0\n1 0 0\n").find("ends inside"), std::string::npos);
    EXPECT_NE(refusal(file, one + "1 1 1 nan\n1 1 nan 0\n").find("header"), std::string::npos);
    EXPECT_NE(refusal(file, one + "1 1 nan 1\n").find("finite"), std::string::npos);
    EXPECT_NE(refusal(file, one + "1 1 x 1\n").find("line 11"), std::string::npos);
    EXPECT_NE(refusal(file, one + "1 1 1 1 5\n").find("5 values"), std::string::npos);
    EXPECT_NE(refusal(file, "1\n2\n" + kIdentity + "1 1 1 1\n1 1 1 1 2 2 2\n").find("line 12"),
              std::string::npos);
    std::string perspective = one;
    perspective.replace(perspective.find("1 0 0 0\n"), 8, "1 0 0 1\n");
    EXPECT_NE(refusal(file, perspective + "1 1 1 1\n").find("affine"), std::string::npos);
}

TEST(PtxFormat, SalvagesWhatIsBeforeTheDamage) {
    VESTIGE_SHARED_OR_SKIP(source, "formats/text/ptx/multiple-and-transform.ptx");
    const TemporaryFolder folder;
    const std::string whole = readBytes(source);
    const auto file = folder / "cut.ptx";
    std::size_t salvaged = 0, refused = 0;
    for (std::size_t length = 0; length < whole.size(); ++length) {
        writeBytes(file, whole.substr(0, length));
        ReadOptions options;
        options.salvage = true;
        const Result<LoadedGeometry> strict = readGeometry(file);
        const Result<LoadedGeometry> loose = readGeometry(file, options);
        if (!strict) ++refused;
        if (strict) {
            EXPECT_TRUE(loose && loose->info.damage.empty()) << length;
        }
        if (!strict && loose) {
            ++salvaged;
            EXPECT_FALSE(loose->info.damage.empty()) << length;
            EXPECT_LE(loose->geometry.vertices.size(), 8);
            const auto& sources = loose->geometry.vertices.attributes().pointSource;
            if (!sources.empty()) {
                EXPECT_EQ(sources[0], 1);
            }
        }
    }
    EXPECT_GT(refused, 400);
    EXPECT_GT(salvaged, 200);
}

TEST(PtxFormat, TellsItsFirstGridAtOnce) {
    VESTIGE_SHARED_OR_SKIP(file, "formats/text/ptx/1.2-with-color.ptx");
    const Result<FileInfo> peeked = peekFile(file);
    ASSERT_TRUE(peeked);
    EXPECT_EQ(peeked->format, "PTX");
    EXPECT_NE(peeked->version.find("15 x 71"), std::string::npos);
}

TEST(TextFormat, ReadsTheSharedPtsFilesAsTheyAre) {
    const std::pair<const char*, std::size_t> kFiles[] = {
        {"autzen.pts", 10}, {"bunny_8.pts", 9}, {"site_56_8.pts", 8}, {"test.pts", 19}};
    for (const auto& [name, points] : kFiles) {
        VESTIGE_SHARED_OR_SKIP(file, std::string("formats/text/pts/") + name);
        const LoadedGeometry read = readOrFail(file);
        EXPECT_EQ(read.geometry.vertices.size(), points) << name;
        const bool bare = std::string(name) == "bunny_8.pts";
        EXPECT_EQ(warnsOf(read.info, "more points than the 8"), bare) << name;
        EXPECT_EQ(read.geometry.vertices.attributes().intensity.empty(), bare) << name;
    }
    VESTIGE_SHARED_OR_SKIP(autzen, "formats/text/pts/autzen.pts");
    const PointCloud cloud = readOrFail(autzen).geometry.vertices;
    EXPECT_LT((cloud.point(0) - Eigen::Vector3d(636110.300003, 849345.050003, 512.139999)).norm(), 1e-6);
    EXPECT_EQ(cloud.attributes().intensity[0], -1613);
    EXPECT_EQ(cloud.attributes().color[0], (Color{52 * 257, 70 * 257, 64 * 257}));
}

TEST(TextFormat, SalvagesTheRowsBeforeTheDamage) {
    const TemporaryFolder folder;
    ReadOptions salvage;
    salvage.salvage = true;
    const std::tuple<const char*, const char*, const char*> kFiles[] = {
        {"a.xyz", "1 2 3\n4 5 6\n7 8", "line 3"}, {"a.pts", "9\n1 2 3\n4 5 6\n", "line 4"}};
    for (const auto& [name, content, place] : kFiles) {
        writeBytes(folder / name, content);
        EXPECT_FALSE(readGeometry(folder / name));
        const Result<LoadedGeometry> loose = readGeometry(folder / name, salvage);
        ASSERT_TRUE(loose);
        EXPECT_EQ(loose->geometry.vertices.size(), 2);
        EXPECT_NE(loose->info.damage.find(place), std::string::npos) << loose->info.damage;
        EXPECT_NE(loose->info.damage.find("the first 2 "), std::string::npos);
    }
    writeBytes(folder / "b.xyz", "1 2 x\n4 5 6\n");
    EXPECT_FALSE(readGeometry(folder / "b.xyz", salvage)) << "there is nothing before it";
}

TEST(TextFormat, ReadsPtsFilesOfSeveralBlocks) {
    const TemporaryFolder folder;
    const auto file = folder / "a.pts";
    writeBytes(file, "2\n1 2 3 -100 1 2 3\n4 5 6 -100 1 2 3\n1\n7 8 9 50 255 2 3\n");
    const LoadedGeometry both = readOrFail(file);
    ASSERT_EQ(both.geometry.vertices.size(), 3);
    EXPECT_TRUE(both.info.warnings.empty());
    EXPECT_NE(refusal(file, "2\n1 2 3\n4 5 6\n2\n7 8 9\n").find("4 points as its counts say"),
              std::string::npos);
    EXPECT_NE(refusal(file, "2\n1 2 3\n1\n4 5 6\n").find("line 3"), std::string::npos);
}

TEST(TextFormat, ReadsWhatEinScanWritesAsAsc) {
    const TemporaryFolder folder;
    writeBytes(folder / "scan.asc", "12.5 -3.25 400.125 0 0 1\n12.6 -3.25 400.125 0 0.6 0.8\n");
    const PointCloud normals = readOrFail(folder / "scan.asc").geometry.vertices;
    ASSERT_EQ(normals.attributes().normal.size(), 2);
    EXPECT_EQ(normals.point(0), Eigen::Vector3d(12.5, -3.25, 400.125));
    writeBytes(folder / "scan.asc", "12.5 -3.25 400.125 200 100 50\n12.6 -3.25 400.125 0 1 255\n");
    EXPECT_EQ(readOrFail(folder / "scan.asc").geometry.vertices.attributes().color[1],
              (Color{0, 257, 255 * 257}));
    writeBytes(folder / "scan.asc", "12.5 -3.25 400.125\n12.6 -3.25 400.125\n");
    EXPECT_EQ(readOrFail(folder / "scan.asc").geometry.vertices.size(), 2);
}

TEST(EinscanMarkers, AreRefusedWithAdvice) {
    const TemporaryFolder folder;
    writeBytes(folder / "markers.p3", std::string("\x01\x02\x03\x04 whatever", 13));
    for (const bool peek : {true, false}) {
        const auto refused = peek ? peekFile(folder / "markers.p3") : fileInfo(folder / "markers.p3");
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, ErrorCode::input);
        EXPECT_NE(refused.error().sentence().find("ASC, PLY, OBJ or STL"), std::string::npos);
    }
    // What another format knows by its content is that.
    ASSERT_TRUE(writeGeometry(folder / "scan.ply", {fullCloud(5, true), {}}));
    std::filesystem::rename(folder / "scan.ply", folder / "scan.p3");
    EXPECT_EQ(readOrFail(folder / "scan.p3").geometry.vertices.size(), 5);
    writeBytes(folder / "a.unknown", "??");
    const auto unknown = peekFile(folder / "a.unknown");
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().sentence().find("p3"), std::string::npos) << "it is not readable";
}
