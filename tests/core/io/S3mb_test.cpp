#include <gtest/gtest.h>

#include "core/base/Random.h"
#include "tests/core/io/Clouds.h"
#include "tests/core/io/S3mbFiles.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

S3mbPoints at(float x, const std::string& child = {}) {
    S3mbPoints part;
    part.positions = {{x, 0, 0}};
    part.child = child;
    return part;
}

std::vector<double> xOf(const std::filesystem::path& file) {
    const PointCloud cloud = readOrFail(file).geometry.vertices;
    std::vector<double> list;
    for (std::size_t i = 0; i < cloud.size(); ++i) list.push_back(cloud.point(i).x());
    return list;
}

bool contains(const std::vector<std::string>& list, const std::string& part) {
    for (const std::string& one : list)
        if (one.find(part) != std::string::npos) return true;
    return false;
}

void expectRefused(const std::filesystem::path& file, const std::string& content, const std::string& part) {
    writeBytes(file, content);
    const Result<LoadedGeometry> loaded = readGeometry(file);
    ASSERT_FALSE(loaded) << part;
    EXPECT_EQ(loaded.error().code, ErrorCode::input);
    EXPECT_NE(loaded.error().sentence().find(part), std::string::npos) << loaded.error().sentence();
    EXPECT_NE(loaded.error().hint.find("expected: "), std::string::npos) << loaded.error().sentence();
}

/// Two skeletons, one with colours and intensities, in their places.
std::string sample(std::uint32_t packing, float version = 3.01F) {
    S3mbPoints first;
    first.name = "\u8f66";  // 3 bytes, so that the padding shows
    first.positions = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
    first.colors = {0xff030201, 0xff0000ff, 0xffff0000};
    first.intensities = {10, 200, 3000};
    first.place = {500000.25, 4400000.5, -12.125};
    S3mbPoints second;
    second.name = "b";
    second.positions = {{0.5F, 0, 0}};
    second.colors = {0xff00ff00};
    second.intensities = {7};
    return s3mbFile(s3mbPackage({first, second}), packing, version);
}

}  // namespace

TEST(S3mb, PointsColoursAndIntensityAreInTheirPlaces) {
    const TemporaryFolder folder;
    for (const std::uint32_t packing : {0U, 1U, 2U})
        for (const float version : {3.0F, 3.01F}) {
            writeBytes(folder / "a.s3mb", sample(packing, version));
            const LoadedGeometry loaded = readOrFail(folder / "a.s3mb");
            const PointCloud& cloud = loaded.geometry.vertices;
            ASSERT_EQ(cloud.size(), 4);
            EXPECT_LT((cloud.point(0) - Eigen::Vector3d(500001.25, 4400002.5, -9.125)).norm(), 1e-9);
            EXPECT_LT((cloud.point(2) - Eigen::Vector3d(500007.25, 4400008.5, -3.125)).norm(), 1e-9);
            EXPECT_LT((cloud.point(3) - Eigen::Vector3d(0.5, 0, 0)).norm(), 1e-9);
            EXPECT_EQ(cloud.attributes().color,
                      (std::vector<Color>{{257, 514, 771}, {65535, 0, 0}, {0, 0, 65535}, {0, 65535, 0}}));
            ASSERT_EQ(cloud.attributes().intensity.size(), 4);
            EXPECT_EQ(cloud.attributes().intensity[2], 3000);
            EXPECT_EQ(cloud.attributes().intensity[3], 7);
            EXPECT_EQ(loaded.info.metresPerUnit, 1.0);
            EXPECT_TRUE(contains(loaded.info.warnings, "by SuperMap's specification alone"));
        }
}

TEST(S3mb, DracoPointsAreThoseOfTheSameStreamInAPointTile) {
    VESTIGE_SHARED_OR_SKIP(source, "formats/pnts/PointCloud/PointCloudDraco/pointCloudDraco.pnts");
    const std::string tile = readBytes(source);
    const std::string stream = tile.substr(tile.find("DRACO"), 15300);
    const TemporaryFolder folder;
    writeBytes(folder / "a.s3mb", s3mbFile(s3mbDracoPackage(stream, 0, 2, 1), 1));
    const PointCloud cloud = readOrFail(folder / "a.s3mb").geometry.vertices;
    const PointCloud reference = readOrFail(source).geometry.vertices;
    ASSERT_EQ(cloud.size(), 1000);
    const Eigen::Vector3d centre(1215012.8828876738, -4736313.051199594, 4081605.22126042);
    for (std::size_t i = 0; i < cloud.size(); ++i)
        ASSERT_LT((cloud.point(i) + centre - reference.point(i)).norm(), 1e-6);
    expectSameAttributes(reference, cloud);
    expectRefused(folder / "a.s3mb", s3mbFile(s3mbDracoPackage(stream, 9, -1, -1)), "no attribute 9");
    expectRefused(folder / "a.s3mb", s3mbFile(s3mbDracoPackage(stream, -1, -1, -1)), "no positions");
    expectRefused(folder / "a.s3mb", s3mbFile(s3mbDracoPackage(stream.substr(0, 5000), 0, 2, 1)), "Draco");
}

TEST(S3mb, TheIndexSaysHowLevelsFollowEachOther) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "a");
    writeBytes(folder / "a/0.s3mb", s3mbFile(s3mbPackage({at(1, "1.s3mb"), [] {
                                                              S3mbPoints leaf = at(2);
                                                              leaf.name = "leaf";
                                                              return leaf;
                                                          }()})));
    writeBytes(folder / "a/1.s3mb", s3mbFile(s3mbPackage({at(3)}), 1));
    writeBytes(folder / "b.s3mb", s3mbFile(s3mbPackage({at(4)}), 2));
    writeBytes(folder / "add.scp", s3mbIndex("Add", {"./a/0.s3mb", "b.s3mb"}));
    EXPECT_EQ(xOf(folder / "add.scp"), (std::vector<double>{1, 2, 3, 4}));
    writeBytes(folder / "replace.scp", s3mbIndex("Replace", {"./a/0.s3mb", "b.s3mb"}));
    EXPECT_EQ(xOf(folder / "replace.scp"), (std::vector<double>{2, 3, 4}));
    const LoadedGeometry alone = readOrFail(folder / "a/0.s3mb");
    EXPECT_EQ(alone.info.points, 2);
    EXPECT_TRUE(contains(alone.info.warnings, "1 finer tile not read"));

    writeBytes(folder / "metres.scp",
               s3mbIndex("Add", {"b.s3mb"}, R"(,"crs":"epsg:4547","position":{"unit":"Meter",
                   "point3D":{"x":499999.125,"y":4400000.5,"z":31}})"));
    const LoadedGeometry metres = readOrFail(folder / "metres.scp");
    EXPECT_EQ(metres.geometry.vertices.point(0), Eigen::Vector3d(500003.125, 4400000.5, 31));
    EXPECT_EQ(metres.info.crs, "epsg:4547");
    writeBytes(folder / "degrees.scp",
               s3mbIndex("Add", {"b.s3mb"}, R"(,"crs":"epsg:4490","position":{"unit":"Degree",
                   "point3D":{"x":116.36254801,"y":39.99005683,"z":0}})"));
    const LoadedGeometry degrees = readOrFail(folder / "degrees.scp");
    EXPECT_EQ(degrees.geometry.vertices.point(0), Eigen::Vector3d(4, 0, 0));
    EXPECT_EQ(degrees.info.crs, "");
    EXPECT_TRUE(contains(degrees.info.warnings, "longitude 116.36254801, latitude 39.99005683"));
}

TEST(S3mb, WhatIsNotUnderstoodIsRefusedWithAWayOut) {
    const TemporaryFolder folder;
    const auto tile = folder / "a.s3mb";
    const std::string package = s3mbPackage({at(1)});
    expectRefused(tile, s3mbFile(package, 0, 2.0F), "version 2.00");
    expectRefused(tile, s3mbFile(package, 0, 1e30F), "no S3MB tile");
    expectRefused(tile, "abc", "inside the header");
    std::string packing = s3mbFile(package);
    packing[4] = 9;
    expectRefused(tile, packing, "packed in the way 9");
    expectRefused(tile, packing, "export the cloud as LAS");
    S3mbPoints mesh = at(1);
    mesh.primitive = 4;
    writeBytes(tile, s3mbFile(s3mbPackage({mesh})));
    EXPECT_TRUE(contains(readOrFail(tile).info.warnings, "1 part of lines or surfaces passed over"));
    S3mbPoints turned = at(1);
    turned.place.x() = std::numeric_limits<double>::infinity();
    expectRefused(tile, s3mbFile(s3mbPackage({turned})), "not affine");
    S3mbPoints same = at(2);
    expectRefused(tile, s3mbFile(s3mbPackage({at(1), same})), "two skeletons have the name points");

    writeBytes(tile, s3mbFile(package));
    const auto index = folder / "a.scp";
    std::filesystem::create_directories(folder / "in");
    expectRefused(index, "<SuperMapCache/>", "is XML");
    expectRefused(index, R"({"dataType":"BIM"})", "'BIM'");
    expectRefused(index, s3mbIndex("Both", {"a.s3mb"}), "lodType 'Both'");
    expectRefused(index, s3mbIndex("Add", {}), "names no tiles");
    expectRefused(index, s3mbIndex("Add", {"none.s3mb"}), "is missing");
    expectRefused(index, s3mbIndex("Add", {"a.s3mb", "./a.s3mb"}), "named a second time");
    expectRefused(index, s3mbIndex("Add", {"http://example.org/a.s3mb"}), "not a file beside it");
    expectRefused(folder / "in/a.scp", s3mbIndex("Add", {"../a.s3mb"}), "outside the folder");
    expectRefused(index, s3mbIndex("Add", {"a.s3mb"}, R"(,"position":{"point3D":{"x":1}})"), "no point");
    expectRefused(
        index, s3mbIndex("Add", {"a.s3mb"}, R"(,"position":{"unit":"Foot","point3D":{"x":1,"y":1,"z":1}})"),
        "unit 'Foot'");
    writeBytes(folder / "loop.s3mb", s3mbFile(s3mbPackage({at(1, "loop.s3mb")})));
    expectRefused(index, s3mbIndex("Replace", {"loop.s3mb"}), "named a second time");
}

TEST(S3mb, PackedTilesCannotBurst) {
    const TemporaryFolder folder;
    const auto file = folder / "a.s3mb";
    std::string promise = sample(1);
    promise.replace(8, 4, std::string("\0\0\0\x3f", 4));
    expectRefused(file, promise, "promises to unpack to");
    promise.replace(8, 4, std::string("\x40\0\0\0", 4));
    expectRefused(file, promise, "a packed part is damaged");
    std::string broken = sample(2);
    broken[30] = static_cast<char>(broken[30] ^ 1);
    expectRefused(file, broken, "a packed part is damaged");
}

TEST(S3mb, CutOffOrWrongItIsReadOrRefused) {
    const TemporaryFolder folder;
    const auto file = folder / "a.s3mb";
    const std::string whole = sample(0);
    for (std::size_t length = 1; length < whole.size(); length += 7) {
        writeBytes(file, whole.substr(0, length));
        const auto loaded = readGeometry(file);
        ASSERT_FALSE(loaded) << length;
        EXPECT_EQ(loaded.error().code, ErrorCode::input);
    }
    for (std::uint64_t round = 0; round < 250; ++round) {
        Random random(31, round);
        std::string damaged = whole;
        for (std::uint64_t i = 0; i <= random.below(4); ++i)
            damaged[random.below(damaged.size())] = static_cast<char>(random.below(256));
        writeBytes(file, damaged);
        const auto loaded = readGeometry(file);
        if (loaded) {
            EXPECT_LE(loaded->geometry.vertices.size(), 4) << round;
        } else {
            EXPECT_EQ(loaded.error().code, ErrorCode::input) << round;
        }
    }
}

TEST(S3mb, SalvageReadsTheTilesThatAreThere) {
    const TemporaryFolder folder;
    writeBytes(folder / "a.s3mb", s3mbFile(s3mbPackage({at(1)})));
    writeBytes(folder / "b.s3mb", s3mbFile(s3mbPackage({at(2)})).substr(0, 100));
    writeBytes(folder / "a.scp", s3mbIndex("Add", {"b.s3mb", "none.s3mb", "a.s3mb"}));
    ReadOptions salvage;
    salvage.salvage = true;
    const auto saved = readGeometry(folder / "a.scp", salvage);
    ASSERT_TRUE(saved) << saved.error().sentence();
    EXPECT_EQ(saved->info.points, 1);
    EXPECT_EQ(saved->info.damage.find("2 of the tiles could not be read"), 0) << saved->info.damage;
    EXPECT_FALSE(readGeometry(folder / "a.scp"));
}
