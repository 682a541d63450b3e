#include <gtest/gtest.h>

#include "tests/core/io/Clouds.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

constexpr std::size_t kPoints = 60;

/// Bare points in an order that a cut shows in; `kPoints` of them where the format has points of its own.
std::string contentOf(const std::string& kind, const TemporaryFolder& folder) {
    std::string rows, facets;
    for (std::size_t i = 0; i < kPoints; ++i) {
        const std::string x = std::to_string(i);
        rows += x + ".25 " + x + ".5 7.125\n";
        if (i % 3 == 0) facets += "facet normal 0 0 1\nouter loop\n";
        facets += "vertex " + x + ".25 " + x + ".5 7.125\n";
        if (i % 3 == 2) facets += "endloop\nendfacet\n";
    }
    const std::string count = std::to_string(kPoints);
    const std::string xyz = "property float x\nproperty float y\nproperty float z\nend_header\n";
    if (kind == "ascii.ply") return "ply\nformat ascii 1.0\nelement vertex " + count + "\n" + xyz + rows;
    if (kind == "ascii.pcd")
        return "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS " + count + "\nDATA ascii\n" + rows;
    if (kind == "rows.xyz") return rows;
    if (kind == "counted.pts") return count + "\n" + rows;
    if (kind == "ascii.vtk")
        return "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS " + count + " float\n" + rows;
    if (kind == "ascii.stl") return "solid s\n" + facets + "endsolid s\n";
    if (kind == "binary.stl") {
        std::string file(80, ' ');
        file += std::string("\x14\0\0\0", 4);
        for (std::uint32_t facet = 0; facet < kPoints / 3; ++facet) {
            std::array<float, 12> numbers{};
            for (std::size_t i = 3; i < numbers.size(); ++i) numbers[i] = static_cast<float>(12 * facet + i);
            file.append(reinterpret_cast<const char*>(numbers.data()), sizeof(numbers));
            file += std::string(2, '\0');
        }
        return file;
    }
    const auto file = folder / ("whole" + std::filesystem::path(kind).extension().string());
    EXPECT_TRUE(writeGeometry(file, {fullCloud(kPoints, true), {}}));
    return readBytes(file);
}

Result<LoadedGeometry> salvaged(const std::filesystem::path& file) {
    ReadOptions options;
    options.salvage = true;
    return readGeometry(file, options);
}

class Salvage : public testing::TestWithParam<const char*> {};

}  // namespace

TEST_P(Salvage, OfAFileCutAnywhereTheFirstPointsAreReadAndTheRestIsSaid) {
    const TemporaryFolder folder;
    const std::string kind = GetParam();
    const std::string whole = contentOf(kind, folder);
    const auto file = folder / kind;
    writeBytes(file, whole);
    const PointCloud all = readOrFail(file).geometry.vertices;
    ASSERT_EQ(all.size(), kPoints);
    const auto undamaged = salvaged(file);
    ASSERT_TRUE(undamaged);
    EXPECT_TRUE(undamaged->info.damage.empty());
    EXPECT_EQ(largestDifference(undamaged->geometry.vertices, all), 0);

    std::size_t before = 0, partly = 0;
    for (std::size_t length = 1; length < whole.size(); length += 7) {
        writeBytes(file, whole.substr(0, length));
        const auto refused = readGeometry(file);
        const auto part = salvaged(file);
        if (refused) {  // cut between two rows, or inside a number, of a file that says no count
            EXPECT_TRUE(part && part->info.damage.empty()) << length;
            continue;
        }
        EXPECT_EQ(part.has_value(), refused.error().salvageable) << length << refused.error().sentence();
        EXPECT_EQ(refused.error().hint.find("--salvage") != std::string::npos, refused.error().salvageable);
        if (!part) continue;
        const PointCloud& cloud = part->geometry.vertices;
        ++partly;
        EXPECT_GE(cloud.size(), before) << length;
        before = cloud.size();
        EXPECT_NE(part->info.damage.find("the file is damaged, "), std::string::npos) << part->info.damage;
        EXPECT_EQ(part->info.warnings.front(), part->info.damage);
        // The last value of text may be cut, and is a number all the same.
        const std::size_t sure = cloud.size() - 1;
        for (std::size_t i = 0; i < sure; ++i) EXPECT_EQ(cloud.point(i), all.point(i)) << length << " " << i;
    }
    EXPECT_GT(partly, 10);
    EXPECT_GE(before, kPoints - 4);
}

INSTANTIATE_TEST_SUITE_P(Formats, Salvage,
                         testing::Values("ascii.ply", "binary.ply", "ascii.pcd", "binary.pcd", "rows.xyz",
                                         "counted.pts", "ascii.vtk", "ascii.stl", "binary.stl"),
                         [](const auto& kind) {
                             std::string name = kind.param;
                             std::replace(name.begin(), name.end(), '.', '_');
                             return name;
                         });

TEST(SalvageMesh, FacesAndAttributesBehindTheDamageAreLeftOut) {
    const TemporaryFolder folder;
    const auto ply = folder / "a.ply";
    writeBytes(
        ply,
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 3\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0\n3 0 1 9\n");
    const auto refused = readGeometry(ply);
    ASSERT_FALSE(refused);
    EXPECT_EQ(
        refused.error().hint,
        "expected: an index from 0 to 3 - 1; all 3 points and the first 2 of 3 faces are whole and can be "
        "read where damage is allowed (--salvage; in a case \"salvage\": true)");
    auto part = salvaged(ply);
    ASSERT_TRUE(part);
    EXPECT_EQ(part->geometry.triangles.size(), 2);
    EXPECT_EQ(
        part->info.damage,
        "the file is damaged, line 15: face 3 names a vertex that is not there; all 3 points and the first 2 "
        "of 3 faces are whole and were read");

    const auto facesFirst = folder / "b.ply";
    writeBytes(
        facesFirst,
        "ply\nformat ascii 1.0\nelement face 2\nproperty list uchar int vertex_indices\nelement vertex 5\n"
        "property float x\nproperty float y\nproperty float z\nend_header\n"
        "3 0 1 2\n4 0 1 2 4\n0 0 0\n1 0 0\n0 1 0\n1 1");
    part = salvaged(facesFirst);
    ASSERT_TRUE(part);
    EXPECT_EQ(part->geometry.vertices.size(), 3);
    EXPECT_EQ(part->geometry.triangles.size(), 1);

    const auto obj = folder / "c.obj";
    writeBytes(obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\nv 1 1");
    part = salvaged(obj);
    ASSERT_TRUE(part);
    EXPECT_EQ(part->geometry.vertices.size(), 3);
    EXPECT_EQ(part->geometry.triangles.size(), 1);

    const auto vtk = folder / "d.vtk";
    writeBytes(
        vtk,
        "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n0 0 0 1 0 0\nPOINT_DATA 2\n"
        "SCALARS intensity float\nLOOKUP_TABLE default\n5 6\nNORMALS n float\n0 0 1 0 ?");
    part = salvaged(vtk);
    ASSERT_TRUE(part);
    EXPECT_EQ(part->geometry.vertices.size(), 2);
    EXPECT_EQ(part->geometry.vertices.attributes().intensity.size(), 2);
    EXPECT_TRUE(part->geometry.vertices.attributes().normal.empty());
}

TEST(SalvageMesh, ACompressedPcdGivesThePointsOfWhichEveryFieldIsThere) {
    const TemporaryFolder folder;
    // Three floats of two points each, as one run of 24 literals: x x y y z z.
    std::array<float, 6> fields{1, 2, 3, 4, 5, 6};
    std::string content =
        "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS 2\nDATA binary_compressed\n";
    content += std::string("\x1a\0\0\0\x18\0\0\0", 8);
    const std::string bytes(reinterpret_cast<const char*>(fields.data()), sizeof(fields));
    content += '\x13' + bytes.substr(0, 20) + '\x3' + bytes.substr(20);
    const auto file = folder / "a.pcd";
    writeBytes(file, content);
    ASSERT_EQ(readOrFail(file).geometry.vertices.size(), 2);
    writeBytes(file, content.substr(0, content.size() - 1));
    EXPECT_FALSE(readGeometry(file));
    const auto part = salvaged(file);
    ASSERT_TRUE(part);
    ASSERT_EQ(part->geometry.vertices.size(), 1);
    EXPECT_EQ(part->geometry.vertices.point(0), Eigen::Vector3d(1, 3, 5));
}
