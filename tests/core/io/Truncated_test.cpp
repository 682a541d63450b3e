#include <gtest/gtest.h>

#include "core/base/Random.h"
#include "tests/core/io/Clouds.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

std::string contentOf(const std::string& extension, const TemporaryFolder& folder) {
    if (extension == "vtk")
        return "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0\n1 1 0 0 "
               "1 0\n"
               "POLYGONS 1 5\n4 0 1 2 3\nPOINT_DATA 4\nSCALARS intensity float 1\nLOOKUP_TABLE default\n1 2 "
               "3 4\n"
               "NORMALS n float\n0 0 1 0 0 1 0 0 1 0 0 1\n";
    if (extension == "obj") return "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1 4//1\n";
    if (extension == "stl")
        return std::string(80, ' ') + std::string("\1\0\0\0", 4) + std::string(36, '\1') +
               std::string(14, '\2');
    if (extension == "ptx") {
        const std::string axes = "1 1 1\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n1 1 1 1\n";
        return "1\n2\n" + axes + "1 2 3 0.5 1 2 3\n0 0 0 0.5\n2\n1\n" + axes + "4 5 6 1\n7 8 9 1\n";
    }
    if (extension == "sbet") {
        std::string text;
        for (double time = 0; time < 5; ++time) {
            const double values[17] = {time, 0.9, 0.2, 100};
            text.append(reinterpret_cast<const char*>(values), sizeof values);
        }
        return text;
    }
    const auto file = folder / ("whole." + extension);
    EXPECT_TRUE(writeGeometry(file, {fullCloud(40, true), {{0, 1, 2}, {2, 3, 4}}}));
    return readBytes(file);
}

class Damaged : public testing::TestWithParam<const char*> {};

}  // namespace

TEST_P(Damaged, CutOffAnywhereIsReadOrRefused) {
    const TemporaryFolder folder;
    const std::string extension = GetParam();
    const std::string whole = contentOf(extension, folder);
    const auto file = folder / ("cut." + extension);
    const std::size_t points = [&] {
        writeBytes(file, whole);
        return readOrFail(file).geometry.vertices.size();
    }();
    ASSERT_GT(points, 0);
    for (std::size_t length = 0; length < whole.size(); length += 1 + length / 200) {
        writeBytes(file, whole.substr(0, length));
        const Result<LoadedGeometry> cut = readGeometry(file);
        if (cut) {
            EXPECT_LE(cut->geometry.vertices.size(), points) << length;
        } else {
            EXPECT_EQ(cut.error().code, ErrorCode::input) << length;
        }
    }
}

TEST_P(Damaged, WrongBytesAreReadOrRefused) {
    const TemporaryFolder folder;
    const std::string extension = GetParam();
    const std::string whole = contentOf(extension, folder);
    const auto file = folder / ("wrong." + extension);
    for (std::uint64_t round = 0; round < 300; ++round) {
        Random random(11, round);
        std::string damaged = whole;
        for (std::uint64_t i = 0; i <= random.below(4); ++i)
            damaged[random.below(damaged.size())] = static_cast<char>(random.below(256));
        writeBytes(file, damaged);
        const Result<LoadedGeometry> loaded = readGeometry(file);
        if (!loaded) {
            EXPECT_EQ(loaded.error().code, ErrorCode::input) << round;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, Damaged,
                         testing::Values("las", "laz", "e57", "ply", "pcd", "csv", "pts", "vtk", "obj", "stl",
                                         "ptx", "sbet"));
