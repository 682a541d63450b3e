#include <gtest/gtest.h>

#include <cstdio>
#include <sstream>

#include "core/base/Numbers.h"
#include "core/geometry/PointCloudBuilder.h"
#include "tests/core/io/Clouds.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

/// Three scans at UTM coordinates, the second without points.
FileInfo threeScans() {
    FileInfo source;
    for (int i = 0; i < 3; ++i) {
        ScanInfo& scan = source.scans.emplace_back();
        scan.name = "Standpunkt ä ]]> " + std::to_string(i + 1);
        scan.guid = "{guid " + std::to_string(i + 1) + "}";
        scan.sensorVendor = "RIEGL & <Co>";
        scan.sensorModel = "VZ-400";
        scan.sensorSerial = "S" + std::to_string(i);
        scan.fileFromScan.linear() =
            Eigen::AngleAxisd(0.3 + i, Eigen::Vector3d(0.1, 0.2, 1).normalized()).toRotationMatrix();
        scan.fileFromScan.translation() = Eigen::Vector3d(576900.25 + 50 * i, 5188500.5, 160 + 0.125 * i);
    }
    source.crs = "PROJCS[\"WGS 84 / UTM zone 33N\",GEOGCS[\"WGS 84\"]]";
    source.creationDayYear = {60, 2024};
    source.gpsTimeIsAdjustedStandard = true;
    return source;
}

PointCloud cloudOfScans(std::size_t points) {
    const PointCloud cloud = fullCloud(points, true);
    PointAttributes attributes = cloud.attributes();
    for (std::size_t i = 0; i < points; ++i)
        attributes.pointSource[i] = static_cast<std::uint16_t>(i % 3 == 0 ? 3 : 1);
    return cloud.withAttributes(std::move(attributes));
}

/// What tests/core/io/e57_points.py prints of a file.
std::vector<std::string> linesByAnotherReader(const std::filesystem::path& file) {
    const std::string command =
        std::string("python3 '") + VESTIGE_E57_READER + "' '" + file.string() + "' 2>&1";
    std::string text;
    FILE* pipe = ::popen(command.c_str(), "r");
    std::array<char, 65536> buffer{};
    for (std::size_t got = 0; (got = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
        text.append(buffer.data(), got);
    EXPECT_EQ(::pclose(pipe), 0) << text.substr(0, 2000);
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::vector<double> numbersOf(const std::string& line) {
    std::vector<double> numbers;
    std::istringstream stream(line);
    for (std::string word; stream >> word;) numbers.push_back(parseReal(word).value_or(-1e99));
    return numbers;
}

}  // namespace

TEST(E57Writing, AnotherReaderFindsTheSamePoints) {
    const TemporaryFolder folder;
    const PointCloud cloud = fullCloud(2500, true);
    ASSERT_TRUE(writeGeometry(folder / "one.e57", {cloud, {}}));
    const std::vector<std::string> lines = linesByAnotherReader(folder / "one.e57");
    ASSERT_EQ(lines.size(), 1 + cloud.size());
    const PointAttributes& attributes = cloud.attributes();
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const Eigen::Vector3d point = cloud.point(i);
        const Eigen::Vector3f normal = attributes.normal[i];
        const std::vector<double> expected{point.x(),
                                           point.y(),
                                           point.z(),
                                           attributes.intensity[i],
                                           attributes.color[i][0] / 257.0,
                                           attributes.color[i][1] / 257.0,
                                           attributes.color[i][2] / 257.0,
                                           attributes.gpsTime[i],
                                           normal.x(),
                                           normal.y(),
                                           normal.z(),
                                           attributes.returnNumber[i] - 1.0,
                                           static_cast<double>(attributes.returnCount[i]),
                                           static_cast<double>(attributes.classification[i]),
                                           static_cast<double>(attributes.pointSource[i])};
        ASSERT_EQ(numbersOf(lines[i + 1]), expected) << i;
    }
}

TEST(E57Writing, AnotherReaderFindsTheSameScansAndGrid) {
    const TemporaryFolder folder;
    const PointCloud cloud = cloudOfScans(900);
    const FileInfo source = threeScans();
    ASSERT_TRUE(writeGeometry(folder / "three.e57", {cloud, {}}, {&source}));
    const std::vector<std::string> lines = linesByAnotherReader(folder / "three.e57");
    ASSERT_EQ(lines.size(), 3 + cloud.size());
    EXPECT_EQ(lines[0], "scan " + source.scans[0].name);
    EXPECT_EQ(lines[601], "scan " + source.scans[1].name);
    EXPECT_EQ(lines[602], "scan " + source.scans[2].name);
    std::size_t first = 1;
    std::size_t third = 603;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const std::vector<double> found = numbersOf(lines[i % 3 == 0 ? third++ : first++]);
        ASSERT_LT((Eigen::Vector3d(found[0], found[1], found[2]) - cloud.point(i)).norm(), 1e-8);
        ASSERT_EQ(found[3], cloud.attributes().intensity[i]);
    }

    FileInfo grid;
    grid.scale = Eigen::Vector3d(0.001, 0.001, 0.01);
    grid.offset = Eigen::Vector3d(576000, 5188000, 0);
    PointCloudBuilder builder;
    for (int i = 0; i < 1000; ++i) builder.add({576000 + 0.001 * i, 5188000 - 0.1 * i, 0.01 * (i % 7)});
    const PointCloud onGrid = std::move(builder).build();
    ASSERT_TRUE(writeGeometry(folder / "grid.e57", {onGrid, {}}, {&grid}));
    EXPECT_LT(std::filesystem::file_size(folder / "grid.e57"), 8192);
    const std::vector<std::string> rows = linesByAnotherReader(folder / "grid.e57");
    ASSERT_EQ(rows.size(), 1001);
    for (int i = 0; i < 1000; ++i)
        EXPECT_EQ(numbersOf(rows[static_cast<std::size_t>(i) + 1]),
                  (std::vector<double>{i * 0.001 + 576000, -100 * i * 0.001 + 5188000, (i % 7) * 0.01}));
}

TEST(E57Writing, ScansComeBackWithTheirPoseAndSensor) {
    const TemporaryFolder folder;
    const PointCloud cloud = cloudOfScans(200000);
    const FileInfo source = threeScans();
    ASSERT_TRUE(writeGeometry(folder / "three.e57", {cloud, {}}, {&source}));
    const LoadedGeometry back = readOrFail(folder / "three.e57");
    ASSERT_EQ(back.info.scans.size(), 3);
    for (std::size_t i = 0; i < 3; ++i) {
        const ScanInfo& a = source.scans[i];
        const ScanInfo& b = back.info.scans[i];
        EXPECT_EQ(a.name, b.name);
        EXPECT_EQ(a.guid, b.guid);
        EXPECT_EQ(a.sensorVendor, b.sensorVendor);
        EXPECT_EQ(a.sensorModel, b.sensorModel);
        EXPECT_EQ(a.sensorSerial, b.sensorSerial);
        EXPECT_LT((a.fileFromScan.matrix() - b.fileFromScan.matrix()).cwiseAbs().maxCoeff(), 1e-14);
    }
    EXPECT_EQ(back.info.scans[0].points, 133333);
    EXPECT_EQ(back.info.scans[1].points, 0);
    EXPECT_EQ(back.info.scans[2].points, 66667);
    EXPECT_EQ(back.info.crs, source.crs);
    EXPECT_EQ(back.info.creationDayYear, source.creationDayYear);
    EXPECT_TRUE(back.info.gpsTimeIsAdjustedStandard);
    std::vector<std::uint32_t> order;
    for (const bool last : {false, true})
        for (std::uint32_t i = 0; i < cloud.size(); ++i)
            if ((i % 3 == 0) == last) order.push_back(i);
    const PointCloud expected = cloud.select(order);
    EXPECT_LT(largestDifference(expected, back.geometry.vertices), 3e-5);
    EXPECT_EQ(expected.attributes().gpsTime, back.geometry.vertices.attributes().gpsTime);
    EXPECT_EQ(expected.attributes().pointSource, back.geometry.vertices.attributes().pointSource);
    EXPECT_EQ(expected.attributes().color, back.geometry.vertices.attributes().color);
}

TEST(E57Writing, TheSameInputGivesTheSameBytes) {
    const TemporaryFolder folder;
    const FileInfo source = threeScans();
    ASSERT_TRUE(writeGeometry(folder / "a.e57", {cloudOfScans(3000), {}}, {&source}));
    ASSERT_TRUE(writeGeometry(folder / "b.e57", {cloudOfScans(3000), {}}, {&source}));
    EXPECT_EQ(readBytes(folder / "a.e57"), readBytes(folder / "b.e57"));
    // Other points, another GUID.
    ASSERT_TRUE(writeGeometry(folder / "c.e57", {cloudOfScans(2999), {}}, {&source}));
    const auto guid = [&](const char* name) {
        const std::string bytes = readBytes(folder / name);
        return bytes.substr(bytes.find("<guid"), 60);
    };
    EXPECT_NE(guid("a.e57"), guid("c.e57"));
}

TEST(E57Writing, AFlightComesBackFromE57AsItWas) {
    VESTIGE_SHARED_OR_SKIP(las, "aerial/las/autzen_trim.las");
    const TemporaryFolder folder;
    const LoadedGeometry original = readOrFail(las);
    ASSERT_TRUE(writeGeometry(folder / "there.e57", original.geometry, {&original.info}));
    const LoadedGeometry there = readOrFail(folder / "there.e57");
    EXPECT_EQ(original.info.scale, there.info.scale);
    EXPECT_EQ(original.info.offset, there.info.offset);
    // To a float offset's rounding, the original's points being exact on their grid.
    EXPECT_LT(largestDifference(original.geometry.vertices, there.geometry.vertices), 1.6e-5);
    expectSameAttributes(original.geometry.vertices, there.geometry.vertices);
    EXPECT_EQ(original.info.attributes.size(), there.info.attributes.size());
    ASSERT_TRUE(writeGeometry(folder / "back.las", there.geometry, {&there.info}));
    ASSERT_TRUE(writeGeometry(folder / "direct.las", original.geometry, {&original.info}));
    const LoadedGeometry back = readOrFail(folder / "back.las");
    EXPECT_EQ(largestDifference(back.geometry.vertices, original.geometry.vertices), 0);
}

TEST(E57Writing, TheCornersOfASurfaceAreWrittenAndTheRestIsTold) {
    const TemporaryFolder folder;
    std::string told;
    const JobControl control({}, [&](std::string_view message) { told += message; });
    const TriangleMesh mesh{fullCloud(3, true), {{0, 1, 2}}};
    ASSERT_TRUE(writeGeometry(folder / "mesh.e57", mesh, {}, control));
    EXPECT_NE(told.find("1 triangle left out"), std::string::npos) << told;
    EXPECT_EQ(readOrFail(folder / "mesh.e57").geometry.vertices.size(), 3);
}
