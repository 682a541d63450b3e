#include <gtest/gtest.h>

#include "core/io/LasWriter.h"
#include "tests/core/io/Clouds.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

TriangleMesh square() {
    return {fullCloud(4, true), {{0, 1, 2}, {0, 2, 3}}};
}

class RoundTrip : public testing::TestWithParam<const char*> {};

bool has(const FileInfo& info, const std::string& attribute) {
    return std::find(info.attributes.begin(), info.attributes.end(), attribute) != info.attributes.end();
}

}  // namespace

TEST_P(RoundTrip, KeepsCoordinatesAndAttributes) {
    const TemporaryFolder folder;
    const std::string extension = GetParam();
    for (const bool bytes : {true, false}) {
        const PointCloud cloud = fullCloud(3000, bytes);
        const auto file = folder / ("cloud." + extension);
        const Status written = writeGeometry(file, {cloud, {}});
        ASSERT_TRUE(written) << written.error().sentence();
        const LoadedGeometry back = readOrFail(file);
        EXPECT_LT(largestDifference(cloud, back.geometry.vertices), 1e-4);
        expectSameAttributes(cloud, back.geometry.vertices);
        EXPECT_TRUE(has(back.info, "intensity"));
        EXPECT_TRUE(has(back.info, "color"));
        for (const char* name :
             {"classification", "gps_time", "point_source", "return_number", "return_count"})
            EXPECT_EQ(has(back.info, name), extension != "pts") << name;
        EXPECT_EQ(has(back.info, "normals"), extension != "pts" && extension != "las" && extension != "laz");
        EXPECT_TRUE(back.info.warnings.empty()) << back.info.warnings.front();
    }
}

TEST_P(RoundTrip, KeepsBareAndEmptyClouds) {
    const TemporaryFolder folder;
    const auto file = folder / (std::string("cloud.") + GetParam());
    const PointCloud bare = fullCloud(5, true).withAttributes({});
    ASSERT_TRUE(writeGeometry(file, {bare, {}}));
    const LoadedGeometry back = readOrFail(file);
    EXPECT_LT(largestDifference(bare, back.geometry.vertices), 1e-4);
    EXPECT_TRUE(back.geometry.vertices.attributes().color.empty());
    EXPECT_TRUE(back.geometry.vertices.attributes().gpsTime.empty());
    ASSERT_TRUE(writeGeometry(file, {}));
    const Result<LoadedGeometry> nothing = readGeometry(file);
    if (nothing) {
        EXPECT_EQ(nothing->geometry.vertices.size(), 0);
    } else {
        EXPECT_EQ(nothing.error().code, ErrorCode::input);
    }
}

TEST_P(RoundTrip, WritesTheSameBytesAgain) {
    const TemporaryFolder folder;
    const TriangleMesh mesh = square();
    const auto one = folder / (std::string("one.") + GetParam());
    const auto two = folder / (std::string("two.") + GetParam());
    ASSERT_TRUE(writeGeometry(one, mesh));
    ASSERT_TRUE(writeGeometry(two, mesh));
    EXPECT_EQ(readBytes(one), readBytes(two));
}

TEST_P(RoundTrip, LeavesWhatStoodThereWhenCancelled) {
    const TemporaryFolder folder;
    const auto file = folder / (std::string("cloud.") + GetParam());
    writeBytes(file, "before");
    const JobControl control;
    control.cancel();
    const Status written = writeGeometry(file, {fullCloud(10, true), {}}, {}, control);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::cancelled);
    EXPECT_EQ(readBytes(file), "before");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

INSTANTIATE_TEST_SUITE_P(Formats, RoundTrip,
                         testing::Values("las", "laz", "e57", "ply", "pcd", "csv", "xyz", "txt", "asc", "pts"));

TEST(PlyFormat, KeepsTriangles) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeGeometry(folder / "mesh.ply", square()));
    EXPECT_EQ(readOrFail(folder / "mesh.ply").geometry.triangles, square().triangles);
}

TEST(WriteGeometry, SaysWhatCanBeWritten) {
    const Status unknown = writeGeometry("cloud.stl", square());
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().code, ErrorCode::usage);
    EXPECT_NE(unknown.error().sentence().find("laz"), std::string::npos);
    const Status nowhere = writeGeometry("/proc/no/cloud.ply", square());
    ASSERT_FALSE(nowhere);
    EXPECT_EQ(nowhere.error().code, ErrorCode::output);
}
