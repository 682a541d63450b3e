#include <gtest/gtest.h>

#include <cmath>

#include "core/io/formats/PntsPoints.h"
#include "tests/core/io/Clouds.h"
#include "tests/core/io/TileFiles.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

std::string sampleName(const std::string& variant) {
    return "formats/pnts/PointCloud/PointCloud" + variant + "/pointCloud" + variant + ".pnts";
}

double largestTurn(const PointCloud& a, const PointCloud& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max(
            largest,
            std::acos(std::clamp(double(a.attributes().normal[i].dot(b.attributes().normal[i])), -1.0, 1.0)));
    return largest;
}

int largestColorStep(const PointCloud& a, const PointCloud& b) {
    int largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            largest = std::max(largest,
                               std::abs(a.attributes().color[i][c] / 257 - b.attributes().color[i][c] / 257));
    return largest;
}

bool contains(const std::vector<std::string>& list, const std::string& part) {
    for (const std::string& one : list)
        if (one.find(part) != std::string::npos) return true;
    return false;
}

}  // namespace

#define SAMPLE_OR_SKIP(variable, variant)                               \
    VESTIGE_SHARED_OR_SKIP(variable##File, sampleName(variant));        \
    const LoadedGeometry variable##Loaded = readOrFail(variable##File); \
    const PointCloud& variable = variable##Loaded.geometry.vertices

TEST(Pnts, TheVariantsOfTheLooseCloudAgreeWithinTheirQuantisation) {
    SAMPLE_OR_SKIP(rgb, "RGB");
    SAMPLE_OR_SKIP(rgba, "RGBA");
    SAMPLE_OR_SKIP(packed, "RGB565");
    SAMPLE_OR_SKIP(plain, "NoColor");
    SAMPLE_OR_SKIP(constant, "ConstantColor");
    SAMPLE_OR_SKIP(quantised, "Quantized");
    SAMPLE_OR_SKIP(wgs84, "WGS84");
    ASSERT_EQ(rgb.size(), 1000);
    EXPECT_EQ(rgbLoaded.info.metresPerUnit, 1.0);
    EXPECT_EQ(rgbLoaded.info.attributes, std::vector<std::string>{"color"});
    EXPECT_TRUE(rgbLoaded.info.warnings.empty());
    for (const PointCloud* same : {&rgba, &packed, &plain, &constant})
        EXPECT_EQ(largestDifference(rgb, *same), 0);
    // 10 m in 65535 steps, cut off, not rounded; and half the spacing of floats at 4.7 million metres.
    EXPECT_LT(largestDifference(rgb, quantised), 10 / 65535.0 + 1e-6);
    EXPECT_LE(largestDifference(rgb, wgs84), 0.25 + 1e-6);
    EXPECT_EQ(largestColorStep(rgb, rgba), 0);
    EXPECT_EQ(largestColorStep(rgb, quantised), 0);
    EXPECT_LE(largestColorStep(rgb, packed), 8);
    EXPECT_TRUE(plain.attributes().color.empty());
    for (const Color& color : constant.attributes().color) EXPECT_EQ(color, (Color{65535, 65535, 0}));
}

TEST(Pnts, TheVariantsOfTheSphereAgreeWithinTheirQuantisation) {
    SAMPLE_OR_SKIP(sphere, "Normals");
    SAMPLE_OR_SKIP(oct, "NormalsOctEncoded");
    SAMPLE_OR_SKIP(quantised, "QuantizedOctEncoded");
    SAMPLE_OR_SKIP(batched, "Batched");
    SAMPLE_OR_SKIP(draco, "Draco");
    SAMPLE_OR_SKIP(partial, "DracoPartial");
    SAMPLE_OR_SKIP(dracoBatched, "DracoBatched");
    ASSERT_EQ(sphere.size(), 1000);
    EXPECT_EQ(largestDifference(sphere, oct), 0);
    EXPECT_EQ(largestDifference(sphere, batched), 0);
    EXPECT_LT(largestDifference(sphere, quantised), 10 / 65535.0 + 1e-6);
    EXPECT_LT(largestTurn(sphere, batched), 1e-3);
    EXPECT_LT(largestTurn(sphere, oct), 0.02);
    EXPECT_LT(largestTurn(sphere, quantised), 0.02);
    for (const PointCloud* other : {&draco, &partial, &dracoBatched}) {
        EXPECT_LT(largestDifference(sphere, *other), 10 / 16384.0);
        EXPECT_LT(largestTurn(sphere, *other), 0.02);
    }
    EXPECT_LT(largestTurn(sphere, partial), 1e-3);
    EXPECT_EQ(largestColorStep(sphere, oct), 0);
    EXPECT_EQ(largestColorStep(sphere, draco), 0);
    EXPECT_EQ(largestColorStep(sphere, partial), 0);
    EXPECT_TRUE(contains(dracoLoaded.info.warnings, "not kept: id, secondaryColor, temperature"));
    EXPECT_TRUE(contains(batchedLoaded.info.warnings, "not kept: BATCH_ID, dimensions, id, name"));
}

TEST(Pnts, WhatIsNotKeptIsNamedInItsOwnScript) {
    SAMPLE_OR_SKIP(properties, "WithPerPointProperties");
    SAMPLE_OR_SKIP(unicode, "WithUnicodePropertyIds");
    EXPECT_EQ(largestDifference(properties, unicode), 0);
    EXPECT_TRUE(contains(propertiesLoaded.info.warnings, "temperature"));
    EXPECT_TRUE(contains(unicodeLoaded.info.warnings, "temperature \u2103"));
}

TEST(Pnts, PropertiesOfPointsAndBatchesBecomeAttributes) {
    const TemporaryFolder folder;
    const std::string positions = bytesOf<float>({0, 0, 0, 1, 0, 0, 0, 2, 0});
    writeBytes(folder / "points.pnts",
               pntsBytes(R"({"POINTS_LENGTH":3,"POSITION":{"byteOffset":0}})", positions,
                         R"({"Intensity":{"byteOffset":0,"componentType":"UNSIGNED_SHORT","type":"SCALAR"},
                             "Classification":{"byteOffset":6,"componentType":"UNSIGNED_BYTE","type":"SCALAR"},
                             "GpsTime":{"byteOffset":9,"componentType":"DOUBLE","type":"SCALAR"},
                             "ReturnNumber":[1,2,3],"names":["a","b","c"]})",
                         bytesOf<std::uint16_t>({7, 300, 65535}) + "\2\5\6" +
                             bytesOf<double>({1e9 + 0.25, 1e9 + 0.5, 1e9 + 0.75})));
    const LoadedGeometry points = readOrFail(folder / "points.pnts");
    const PointAttributes& attributes = points.geometry.vertices.attributes();
    ASSERT_EQ(attributes.intensity.size(), 3);
    EXPECT_EQ(attributes.intensity[2], 65535);
    EXPECT_EQ(attributes.classification, (std::vector<std::uint8_t>{2, 5, 6}));
    EXPECT_EQ(attributes.gpsTime, (std::vector<double>{1e9 + 0.25, 1e9 + 0.5, 1e9 + 0.75}));
    EXPECT_EQ(attributes.returnNumber, (std::vector<std::uint8_t>{1, 2, 3}));
    EXPECT_EQ(points.info.attributes,
              (std::vector<std::string>{"intensity", "classification", "gps_time", "return_number"}));
    EXPECT_TRUE(contains(points.info.warnings, "not kept: names"));

    writeBytes(folder / "batches.pnts",
               pntsBytes(R"({"POINTS_LENGTH":3,"BATCH_LENGTH":2,"POSITION":{"byteOffset":0},
                             "BATCH_ID":{"byteOffset":36,"componentType":"UNSIGNED_BYTE"}})",
                         positions + std::string("\1\0\1", 3), R"({"classification":[2,6]})"));
    EXPECT_EQ(readOrFail(folder / "batches.pnts").geometry.vertices.attributes().classification,
              (std::vector<std::uint8_t>{6, 2, 6}));
}

TEST(Pnts, CentreAndVolumeAreDouble) {
    const TemporaryFolder folder;
    writeBytes(folder / "a.pnts",
               pntsBytes(R"({"POINTS_LENGTH":2,"RTC_CENTER":[4194304.0001,-0.1,6378137.123456],
                             "POSITION":{"byteOffset":0}})",
                         bytesOf<float>({0, 0, 0, 0.5F, 0, -0.25F})));
    const PointCloud cloud = readOrFail(folder / "a.pnts").geometry.vertices;
    EXPECT_LT((cloud.point(0) - Eigen::Vector3d(4194304.0001, -0.1, 6378137.123456)).norm(), 1e-7);
    EXPECT_LT((cloud.point(1) - Eigen::Vector3d(4194304.5001, -0.1, 6378136.873456)).norm(), 1e-7);
    writeBytes(folder / "b.pnts",
               pntsBytes(R"({"POINTS_LENGTH":{"byteOffset":12},"RTC_CENTER":{"byteOffset":0},
                             "QUANTIZED_VOLUME_OFFSET":[1,2,3],"QUANTIZED_VOLUME_SCALE":[65535,1,131070],
                             "POSITION_QUANTIZED":{"byteOffset":16}})",
                         bytesOf<float>({100, 0, 0}) + bytesOf<std::uint32_t>({1}) +
                             bytesOf<std::uint16_t>({5, 65535, 7})));
    EXPECT_EQ(readOrFail(folder / "b.pnts").geometry.vertices.point(0), Eigen::Vector3d(106, 3, 17));
}

TEST(Pnts, OctNormalsHaveUnitLengthAndTheirQuadrant) {
    // The specification's own example: (128, 255) is up along y.
    EXPECT_LT((octNormal(128, 255) - Eigen::Vector3f(0, 1, 0)).norm(), 0.01);
    for (int x = 0; x < 256; ++x)
        for (int y = 0; y < 256; ++y) {
            const Eigen::Vector3f n = octNormal(static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y));
            ASSERT_NEAR(n.norm(), 1, 1e-6);
            // The octahedron's projection takes it back (Meyer et al. 2010).
            Eigen::Vector2d back = n.head<2>().cast<double>() / n.cast<double>().lpNorm<1>();
            if (n.z() < 0)
                back = Eigen::Vector2d(std::copysign(1 - std::abs(back.y()), x - 127.5),
                                       std::copysign(1 - std::abs(back.x()), y - 127.5));
            ASSERT_NEAR((back.x() + 1) * 127.5, x, 1e-3) << x << " " << y;
            ASSERT_NEAR((back.y() + 1) * 127.5, y, 1e-3) << x << " " << y;
        }
}

TEST(Pnts, PeekTellsWhatReadingFinds) {
    for (const char* variant : {"RGB", "Draco", "QuantizedOctEncoded", "Batched"}) {
        VESTIGE_SHARED_OR_SKIP(file, sampleName(variant));
        const Result<FileInfo> peeked = peekFile(file);
        ASSERT_TRUE(peeked) << peeked.error().sentence();
        const FileInfo whole = readOrFail(file).info;
        EXPECT_EQ(peeked->points, whole.points);
        EXPECT_EQ(peeked->format, whole.format);
        EXPECT_EQ(peeked->version, whole.version);
        EXPECT_EQ(peeked->attributes, whole.attributes);
    }
}

TEST(Pnts, OptionsLeaveOutWhatTheySayWhileReading) {
    SAMPLE_OR_SKIP(whole, "Normals");
    ReadOptions options;
    options.box = BoundingBox{whole.bounds().min.array() - 1, whole.bounds().max.array() + 1};
    options.box->max.x() = whole.bounds().centre().x();
    options.keepEvery = 3;
    const auto part = readGeometry(wholeFile, options);
    ASSERT_TRUE(part) << part.error().sentence();
    std::vector<std::uint32_t> wanted;
    std::size_t met = 0;
    for (std::uint32_t i = 0; i < whole.size(); ++i)
        if (whole.point(i).x() <= options.box->max.x() && met++ % 3 == 0) wanted.push_back(i);
    ASSERT_GT(wanted.size(), 100);
    const PointCloud expected = whole.select(wanted);
    EXPECT_EQ(largestDifference(expected, part->geometry.vertices), 0);
    expectSameAttributes(expected, part->geometry.vertices);
    EXPECT_EQ(part->info.points, wanted.size());
}
