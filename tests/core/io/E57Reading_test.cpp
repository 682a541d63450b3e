#include <gtest/gtest.h>

#include "tests/core/io/Clouds.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

TEST(E57Reading, IntegersAndDoublesOfOneBunnyReadEqual) {
    VESTIGE_SHARED_OR_SKIP(integers, "formats/e57/reference/bunnyInt32.e57");
    VESTIGE_SHARED_OR_SKIP(doubles, "formats/e57/reference/bunnyDouble.e57");
    const LoadedGeometry a = readOrFail(integers);
    const LoadedGeometry b = readOrFail(doubles);
    ASSERT_EQ(a.geometry.vertices.size(), 30571);
    EXPECT_LE(largestDifference(a.geometry.vertices, b.geometry.vertices), 0.5e-6 + 1e-9);
    EXPECT_EQ(a.info.scale, Eigen::Vector3d::Constant(1e-6));
    // The file's own bounds.
    EXPECT_LT((a.info.bounds.min - Eigen::Vector3d(-0.094689, 0.040011, -0.061873)).norm(), 1e-6);
    EXPECT_LT((a.info.bounds.max - Eigen::Vector3d(0.061009, 0.187321, 0.058799)).norm(), 1e-6);
    ASSERT_EQ(a.info.scans.size(), 1);
    EXPECT_EQ(a.info.scans[0].name, "bunny");
    EXPECT_EQ(a.info.scans[0].guid, "{9CA24C38-C93E-40E8-A366-F49977C7E3EB}");
    EXPECT_EQ(a.info.generatingSoftware, "InteliSum-LD3-Studio-V5.1-E57RefImpl-1.0.154-x86-windows");
    EXPECT_EQ(a.info.creationDayYear->second, 2011);
    EXPECT_EQ(a.info.metresPerUnit, 1);
}

TEST(E57Reading, FloatsAndDoublesOfOneCubeReadEqual) {
    VESTIGE_SHARED_OR_SKIP(floats, "formats/e57/self/ColouredCubeFloat.e57");
    VESTIGE_SHARED_OR_SKIP(doubles, "formats/e57/self/ColouredCubeDouble.e57");
    const LoadedGeometry a = readOrFail(floats);
    const LoadedGeometry b = readOrFail(doubles);
    ASSERT_EQ(a.geometry.vertices.size(), 7680);
    EXPECT_LE(largestDifference(a.geometry.vertices, b.geometry.vertices), 1e-7);
    ASSERT_FALSE(a.geometry.vertices.attributes().color.empty());
    expectSameAttributes(a.geometry.vertices, b.geometry.vertices);
    for (const Color& color : a.geometry.vertices.attributes().color)
        for (const std::uint16_t channel : color) EXPECT_EQ(channel % 257, 0);
}

TEST(E57Reading, ReturnsColoursAndSourcesOfAConvertedLasFile) {
    VESTIGE_SHARED_OR_SKIP(file, "formats/e57/3rdParty/las2e57/ColourRepresentation.e57");
    const LoadedGeometry read = readOrFail(file);
    ASSERT_EQ(read.geometry.vertices.size(), 153);
    EXPECT_EQ(read.info.attributes,
              (std::vector<std::string>{"color", "point_source", "return_number", "return_count"}));
    EXPECT_EQ(read.info.bounds.min, Eigen::Vector3d::Constant(-0.5));
    EXPECT_EQ(read.info.bounds.max, Eigen::Vector3d::Constant(0.5));
    EXPECT_EQ(read.info.creationDayYear->second, 2022);
    // las2e57 copies the numbers of LAS, from 1, where the standard counts from 0.
    const PointAttributes& attributes = read.geometry.vertices.attributes();
    for (std::size_t i = 0; i < 153; ++i) {
        EXPECT_EQ(attributes.returnNumber[i], 1);
        EXPECT_EQ(attributes.returnCount[i], 1);
        EXPECT_EQ(attributes.pointSource[i], 1);
    }
}

TEST(E57Reading, FilesWithoutPointsAreReadAndSayWhatTheyHold) {
    VESTIGE_SHARED_OR_SKIP(folder, "formats/e57/self");
    for (const char* name : {"ZeroPoints.e57", "empty.e57", "test filename äöü.e57", "测试点云.e57"}) {
        const LoadedGeometry read = readOrFail(folder / name);
        EXPECT_EQ(read.geometry.vertices.size(), 0) << name;
        EXPECT_EQ(read.info.warnings, std::vector<std::string>{"the file has no points"}) << name;
    }
    const LoadedGeometry images = readOrFail(folder / "PinholeImageWithDistortionParameters.e57");
    ASSERT_EQ(images.info.images.size(), 3);
    EXPECT_EQ(images.info.images[1].name, "JPEG Image Test 2");
    EXPECT_EQ(images.info.images[1].projection, "pinhole");
    EXPECT_EQ(images.info.images[1].format, "jpeg");
    EXPECT_EQ(images.info.images[1].bytes, 375);
    EXPECT_EQ(images.info.images[1].width, 1);
}
