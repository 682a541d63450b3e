#include <gtest/gtest.h>

#include "core/geometry/PointCloudBuilder.h"
#include "tests/core/io/Clouds.h"
#include "tests/core/io/GltfText.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

/// Three corners, x right, y up, z to the viewer, as float; 36 bytes.
const std::string kCorners = bytesOf<float>({0, 0, 0, 2, 0, 0, 0, 3, 0.5});
const std::string kTriangle =
    R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
    R"("bufferViews":[{"buffer":0,"byteLength":36}],)"
    R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}])";
const std::string kOneNode = R"(,"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}])";

LoadedGeometry readText(const TemporaryFolder& folder, const std::string& buffer, const std::string& rest) {
    writeBytes(folder / "a.gltf", gltfText(buffer, rest));
    return readOrFail(folder / "a.gltf");
}

void expectPoint(const LoadedGeometry& found, std::size_t i, const Eigen::Vector3d& expected) {
    ASSERT_LT(i, found.geometry.vertices.size());
    EXPECT_LT((found.geometry.vertices.point(i) - expected).cwiseAbs().maxCoeff(), 1e-6)
        << found.geometry.vertices.point(i).transpose();
}

}  // namespace

TEST(Gltf, ReadsATriangleWithZUp) {
    const TemporaryFolder folder;
    const LoadedGeometry found = readText(folder, kCorners, kTriangle + kOneNode);
    ASSERT_EQ(found.geometry.vertices.size(), 3);
    expectPoint(found, 1, {2, 0, 0});
    expectPoint(found, 2, {0, -0.5, 3});
    EXPECT_EQ(found.geometry.triangles, (std::vector<Triangle>{{0, 1, 2}}));
    EXPECT_EQ(found.info.metresPerUnit, 1.0);
    EXPECT_TRUE(found.info.warnings.empty()) << found.info.warnings.front();
}

TEST(Gltf, MultipliesNodeMatricesInDouble) {
    const TemporaryFolder folder;
    // UTM in a parent's translation, a quarter turn about x and a scale below it, and the mesh a second time.
    const LoadedGeometry found =
        readText(folder, kCorners,
                 kTriangle + R"(,"scene":0,"scenes":[{"nodes":[0,3]}],"nodes":[)"
                             R"({"translation":[576661.0625,5188114.1234,-310.5],"children":[1]},)"
                             R"({"rotation":[0.70710678118654757,0,0,0.70710678118654757],"children":[2]},)"
                             R"({"mesh":0,"scale":[2,2,2]},)"
                             R"({"mesh":0,"matrix":[-1,0,0,0,0,1,0,0,0,0,1,0,10,20,30,1]}])");
    ASSERT_EQ(found.geometry.vertices.size(), 6);
    // (0, 3, 0.5) doubled is (0, 6, 1), turned (0, -1, 6), then moved; then z up.
    expectPoint(found, 2, {576661.0625, 310.5 - 6, 5188114.1234 - 1});
    expectPoint(found, 5, {10, -30.5, 23});
    ASSERT_EQ(found.geometry.triangles.size(), 2);
    EXPECT_EQ(found.geometry.triangles[1], (Triangle{3, 5, 4})) << "a mirrored mesh is turned inside out";
}

TEST(Gltf, ReadsStripsFansAndIndicesOfEveryWidth) {
    const TemporaryFolder folder;
    const std::string square = bytesOf<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
    const std::string views =
        R"("bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":)";
    const auto read = [&](const std::string& indices, std::size_t count, int type, int mode) {
        return readText(
                   folder, square + indices,
                   views + std::to_string(indices.size()) +
                       R"(}],"accessors":[)"
                       R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
                       R"({"bufferView":1,"type":"SCALAR","count":)" +
                       std::to_string(count) + R"(,"componentType":)" + std::to_string(type) +
                       R"(}],"meshes":[{"primitives":[{"indices":1,"attributes":{"POSITION":0},"mode":)" +
                       std::to_string(mode) + "}]}]" + kOneNode)
            .geometry.triangles;
    };
    const std::vector<Triangle> both{{0, 1, 2}, {2, 1, 3}};
    EXPECT_EQ(read(bytesOf<std::uint8_t>({0, 1, 2, 2, 1, 3}), 6, 5121, 4), both);
    EXPECT_EQ(read(bytesOf<std::uint16_t>({0, 1, 2, 2, 1, 3}), 6, 5123, 4), both);
    EXPECT_EQ(read(bytesOf<std::uint32_t>({0, 1, 2, 2, 1, 3}), 6, 5125, 4), both);
    const std::vector<Triangle> strip = read(bytesOf<std::uint16_t>({0, 1, 2, 3}), 4, 5123, 5);
    ASSERT_EQ(strip.size(), 2);
    EXPECT_EQ(strip[0], (Triangle{0, 1, 2}));
    // The second one of a strip, in any rotation, but not turned over.
    EXPECT_TRUE(strip[1] == (Triangle{2, 1, 3}) || strip[1] == (Triangle{1, 3, 2}) ||
                strip[1] == (Triangle{3, 2, 1}));
    const std::vector<Triangle> fan = read(bytesOf<std::uint16_t>({0, 1, 3, 2}), 4, 5123, 6);
    EXPECT_EQ(fan, (std::vector<Triangle>{{0, 1, 3}, {0, 3, 2}}));
}

TEST(Gltf, ReadsPointsColoursOfEveryKindAndNormals) {
    const TemporaryFolder folder;
    const std::string views =
        R"("bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":)";
    const auto colors = [&](const std::string& bytes, int type, const std::string& kind) {
        const LoadedGeometry found = readText(
            folder, kCorners + bytes,
            views + std::to_string(bytes.size()) +
                R"(}],"accessors":[)"
                R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},)"
                R"({"bufferView":1,"count":3,"type":")" +
                kind + R"(","componentType":)" + std::to_string(type) +
                (type == 5126 ? "" : R"(,"normalized":true)") +
                R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"COLOR_0":1},"mode":0}]}])" +
                kOneNode);
        EXPECT_TRUE(found.geometry.triangles.empty());
        return found.geometry.vertices.attributes().color;
    };
    const LargeArray<Color> expected{{65535, 0, 0}, {0, 51 * 257, 0}, {0, 0, 65535}};
    EXPECT_EQ(colors(bytesOf<std::uint8_t>({255, 0, 0, 255, 0, 51, 0, 255, 0, 0, 255, 255}), 5121, "VEC4"),
              expected);
    EXPECT_EQ(colors(bytesOf<std::uint16_t>({65535, 0, 0, 9, 0, 13107, 0, 9, 0, 0, 65535, 9}), 5123, "VEC4"),
              expected);
    EXPECT_EQ(colors(bytesOf<float>({1, 0, 0, 0, 0.2F, 0, 0, 0, 1}), 5126, "VEC3"), expected);
    EXPECT_EQ(colors(bytesOf<float>({1, 0, 0, 1, 0, 0.2F, 0, 1, 0, 0, 1, 1}), 5126, "VEC4"), expected);

    const LoadedGeometry found =
        readText(folder, kCorners + bytesOf<float>({0, 1, 0, 0, 0, 1, 1, 0, 0}),
                 R"("bufferViews":[{"buffer":0,"byteLength":72}],"accessors":[)"
                 R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},)"
                 R"({"bufferView":0,"byteOffset":36,"componentType":5126,"count":3,"type":"VEC3"}],)"
                 R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1},"mode":0}]}])" +
                     kOneNode);
    EXPECT_EQ(found.geometry.vertices.attributes().normal,
              (std::vector<Eigen::Vector3f>{{0, 0, 1}, {0, -1, 0}, {1, 0, 0}}));
}

TEST(Gltf, ReadsSparseAccessors) {
    const TemporaryFolder folder;
    const LoadedGeometry found = readText(
        folder, kCorners + bytesOf<std::uint16_t>({1, 0}) + bytesOf<float>({7, 8, 9}),
        R"("bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":4},)"
        R"({"buffer":0,"byteOffset":40,"byteLength":12}],"accessors":[{"bufferView":0,"componentType":5126,)"
        R"("count":3,"type":"VEC3","sparse":{"count":1,"indices":{"bufferView":1,"componentType":5123},)"
        R"("values":{"bufferView":2}}}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}])" +
            kOneNode);
    expectPoint(found, 0, {0, 0, 0});
    expectPoint(found, 1, {7, -9, 8});
}

TEST(Gltf, PassesOverLinesAndReadsTheRest) {
    const TemporaryFolder folder;
    const LoadedGeometry found =
        readText(folder, kCorners,
                 R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
                 R"("bufferViews":[{"buffer":0,"byteLength":36}],"meshes":[{"primitives":[)"
                 R"({"attributes":{"POSITION":0},"mode":3},{"attributes":{"POSITION":0},"mode":0},)"
                 R"({"attributes":{"POSITION":0}}]}])" +
                     kOneNode);
    EXPECT_EQ(found.geometry.vertices.size(), 6);
    EXPECT_EQ(found.geometry.triangles, (std::vector<Triangle>{{3, 4, 5}}));
    ASSERT_EQ(found.info.warnings.size(), 1);
    EXPECT_EQ(found.info.warnings[0], "lines are left out");
}

TEST(Gltf, ReadsBuffersBesideTheDocument) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "unter ordner");
    writeBytes(folder / "unter ordner/möbel.bin", kCorners);
    writeBytes(
        folder / "a.gltf",
        R"({"asset":{"version":"2.0"},"buffers":[{"uri":"unter%20ordner/m%C3%B6bel.bin","byteLength":36}],)" +
            kTriangle + kOneNode + "}");
    const LoadedGeometry found = readOrFail(folder / "a.gltf");
    expectPoint(found, 1, {2, 0, 0});
    EXPECT_TRUE(found.info.warnings.empty());
    ASSERT_EQ(found.info.companions.size(), 1);
    EXPECT_EQ(found.info.companions[0].filename(), "möbel.bin");
}

TEST(Gltf, PeekTellsWhatReadingFinds) {
    const TemporaryFolder folder;
    for (const char* name : {"a.glb", "a.gltf"}) {
        const PointCloud cloud = fullCloud(500, true);
        ASSERT_TRUE(writeGeometry(folder / name, {cloud, {{0, 1, 2}}}));
        const Result<FileInfo> peeked = peekFile(folder / name);
        ASSERT_TRUE(peeked) << peeked.error().sentence();
        const FileInfo found = readOrFail(folder / name).info;
        EXPECT_EQ(peeked->points, found.points);
        EXPECT_EQ(peeked->triangles, found.triangles);
        EXPECT_EQ(peeked->version, found.version);
        EXPECT_EQ(peeked->attributes, found.attributes);
        EXPECT_LT((peeked->bounds.min - found.bounds.min).norm(), 1e-3);
        EXPECT_LT((peeked->bounds.max - found.bounds.max).norm(), 1e-3);
    }
}

class GltfRoundTrip : public testing::TestWithParam<const char*> {};

TEST_P(GltfRoundTrip, KeepsUtmCoordinatesColoursNormalsAndTriangles) {
    const TemporaryFolder folder;
    const auto file = folder / (std::string("cloud.") + GetParam());
    for (const bool bytes : {true, false})
        for (const bool mesh : {true, false}) {
            TriangleMesh original{fullCloud(3000, bytes), {}};
            if (mesh)
                for (std::uint32_t i = 0; i + 2 < 3000; ++i) original.triangles.push_back({i, i + 2, i + 1});
            const Status written = writeGeometry(file, original);
            ASSERT_TRUE(written) << written.error().sentence();
            const LoadedGeometry back = readOrFail(file);
            EXPECT_LT(largestDifference(original.vertices, back.geometry.vertices), 5e-5);
            EXPECT_EQ(back.geometry.vertices.attributes().color, original.vertices.attributes().color);
            EXPECT_EQ(back.geometry.vertices.attributes().normal, original.vertices.attributes().normal);
            EXPECT_EQ(back.geometry.triangles, original.triangles);
            EXPECT_TRUE(back.info.warnings.empty()) << back.info.warnings.front();
        }
}

TEST_P(GltfRoundTrip, KeepsATenthOfAMillimetreOverHundredsOfKilometres) {
    const TemporaryFolder folder;
    const auto file = folder / (std::string("wide.") + GetParam());
    PointCloudBuilder builder;
    for (int i = 0; i < 300; ++i)
        builder.add({4000000.1234 + 977.77 * i, 500000.4321 - 1234.5 * (i % 7), 4900000.0001 + 0.3 * i});
    TriangleMesh mesh{std::move(builder).build(), {}};
    for (const bool withTriangles : {false, true}) {
        if (withTriangles)
            for (std::uint32_t i = 0; i + 2 < 300; ++i) mesh.triangles.push_back({i, i + 1, i + 2});
        ASSERT_TRUE(writeGeometry(file, mesh));
        const LoadedGeometry back = readOrFail(file);
        if (!withTriangles) {
            EXPECT_EQ(back.geometry.vertices.size(), 300);
        }
        ASSERT_EQ(back.geometry.triangles.size(), mesh.triangles.size());
        for (std::size_t i = 0; i < 300; ++i) {
            double nearest = 1e9;
            for (std::size_t k = 0; k < back.geometry.vertices.size(); ++k)
                nearest =
                    std::min(nearest, (back.geometry.vertices.point(k) - mesh.vertices.point(i)).norm());
            EXPECT_LT(nearest, 1e-4);
        }
    }
}

TEST_P(GltfRoundTrip, WritesEmptyAndBareCloudsAndTheSameBytesAgain) {
    const TemporaryFolder folder;
    const auto file = folder / (std::string("a.") + GetParam());
    ASSERT_TRUE(writeGeometry(file, {}));
    EXPECT_EQ(readOrFail(file).geometry.vertices.size(), 0);
    const PointCloud bare = fullCloud(5, true).withAttributes({});
    ASSERT_TRUE(writeGeometry(file, {bare, {}}));
    const std::string first = readBytes(file);
    EXPECT_LT(largestDifference(bare, readOrFail(file).geometry.vertices), 5e-5);
    ASSERT_TRUE(writeGeometry(file, {bare, {}}));
    EXPECT_EQ(readBytes(file), first);
}

INSTANTIATE_TEST_SUITE_P(Formats, GltfRoundTrip, testing::Values("glb", "gltf"));
