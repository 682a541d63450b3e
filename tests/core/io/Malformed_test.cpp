#include <sys/resource.h>

#include <gtest/gtest.h>

#include <ctime>
#include <limits>

#include "tests/core/io/Clouds.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

/// Of the processor, so that a busy machine fails nothing.
double secondsOf(const auto& work) {
    const std::clock_t begin = std::clock();
    work();
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

long peakMegabytes() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
}

/// Reads, or refuses with ErrorCode::input and a sentence that names the file and what was expected.
void expectReadOrRefused(const std::filesystem::path& file) {
    const Result<LoadedGeometry> loaded = readGeometry(file);
    if (loaded) return;
    EXPECT_EQ(loaded.error().code, ErrorCode::input) << file;
    EXPECT_NE(loaded.error().place.find(file.string()), std::string::npos) << loaded.error().sentence();
    EXPECT_FALSE(loaded.error().message.empty());
}

void expectRefused(const std::filesystem::path& file, const std::string& content, const std::string& place) {
    writeBytes(file, content);
    const Result<LoadedGeometry> loaded = readGeometry(file);
    ASSERT_FALSE(loaded) << content.substr(0, 200);
    EXPECT_EQ(loaded.error().code, ErrorCode::input);
    EXPECT_EQ(loaded.error().place, file.string() + place) << loaded.error().sentence();
    EXPECT_NE(loaded.error().hint.find("expected: "), std::string::npos) << loaded.error().sentence();
}

const std::string kPlyHead = "ply\nformat binary_little_endian 1.0\n";
const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
const std::string kPcdHead = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n";

}  // namespace

TEST(Malformed, EverySharedFileIsReadOrRefusedQuickly) {
    VESTIGE_SHARED_OR_SKIP(folder, "malformed");
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file()) continue;
        ++files;
        EXPECT_LT(secondsOf([&] { expectReadOrRefused(entry.path()); }), 2) << entry.path();
    }
    EXPECT_GT(files, 50);
    EXPECT_LT(peakMegabytes(), 500);
}

TEST(Malformed, PromisesThatTheFileCannotKeepCostNoMemory) {
    const TemporaryFolder folder;
    expectRefused(folder / "a.ply", kPlyHead + "element vertex 4000000000000\n" + kXyz + "end_header\nxxxx",
                  ", byte 127");
    expectRefused(folder / "b.ply",
                  "ply\nformat ascii 1.0\nelement vertex 900000000\n" + kXyz + "end_header\n1 2 3\n",
                  ", line 8");
    expectRefused(folder / "a.pcd", kPcdHead + "POINTS 800000000000\nDATA binary\nxxxx", ", byte 91");
    expectRefused(folder / "b.pcd", kPcdHead + "POINTS 800000000000\nDATA ascii\n1 2 3\n", ", byte 90");
    expectRefused(folder / "c.pcd",
                  kPcdHead + "POINTS 300000000\nDATA binary_compressed\n" +
                      std::string("\4\0\0\0\0\xa4\x93\xd6xxxx", 12),
                  ", byte 107");
    expectRefused(folder / "a.vtk",
                  "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 90000000 float\n1 2 3\n",
                  ", line 5");
    expectRefused(folder / "a.stl", std::string(80, ' ') + "\xff\xff\xff\xffxxxx", ", byte 80");
    expectRefused(folder / "a.pts", "4000000000\n1 2 3\n", ", line 3");
    EXPECT_LT(peakMegabytes(), 500);
}

TEST(Malformed, TheErrorNamesTheLineOrByte) {
    const TemporaryFolder folder;
    expectRefused(folder / "a.xyz", "1 2 3\n4 5 6\n7 8\n", ", line 3");
    expectRefused(folder / "b.csv", "x,y,z\n1,2,3\n1,,3\n", ", line 3");
    expectRefused(folder / "c.csv", "x,y,x\n1,2,3\n", ", line 1");
    expectRefused(folder / "d.xyz", "1 2 3\n1 nan 3\n", ", line 2");
    expectRefused(folder / "e.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", ", line 4");
    expectRefused(folder / "f.obj", "v 0 0 1e999\n", ", line 1");
    expectRefused(folder / "g.ply",
                  "ply\nformat ascii 1.0\nelement vertex 1\n" + kXyz + "end_header\n1 2 x\n", ", line 8");
    expectRefused(folder / "h.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty half x\n", ", line 4");
    expectRefused(folder / "i.pcd",
                  "VERSION 0.7\nFIELDS x y z\nSIZE 4 4\nTYPE F F F\nPOINTS 1\nDATA ascii\n1 2 3\n",
                  ", line 6");
    expectRefused(folder / "j.las", "LASF" + std::string(100, '\0'), ", byte 104");
    expectRefused(folder / "k.stl",
                  "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\nendfacet\n", ", line 6");
    expectRefused(folder / "l.ply", "", ", byte 0");
    expectRefused(folder / "m.ply", " ", ", line 1");
}

TEST(Malformed, DecimalCommasAreCalledThat) {
    const TemporaryFolder folder;
    for (const char* text : {"1,5 2,5 3,5\n", "1,5;2,5;3,5\n", "1,5\t2,5\t3,5\n"}) {
        writeBytes(folder / "a.xyz", text);
        const Result<LoadedGeometry> loaded = readGeometry(folder / "a.xyz");
        ASSERT_FALSE(loaded) << text;
        EXPECT_NE(loaded.error().sentence().find("decimal commas"), std::string::npos)
            << loaded.error().sentence();
    }
    writeBytes(folder / "b.csv", "1,2,3\n4,5,6\n");
    EXPECT_TRUE(readGeometry(folder / "b.csv")) << "commas part the columns here";
}

TEST(Malformed, CoordinatesBeyondAnyPlaceOnEarthAreRefused) {
    const TemporaryFolder folder;
    expectRefused(folder / "a.xyz", "1 2 3\n4 5e10 6\n", ", line 2");
    expectRefused(folder / "b.xyz", "1 2 3\n4 -inf 6\n", ", line 2");
    expectRefused(folder / "c.obj", "v 0 0 0\nv 1 1e12 0\n", ", line 2");
    expectRefused(folder / "d.ply",
                  "ply\nformat ascii 1.0\nelement vertex 2\n" + kXyz + "end_header\n1 2 3\n1 2 1e300\n",
                  ", line 9");
    expectRefused(folder / "e.pcd", kPcdHead + "POINTS 1\nDATA ascii\n1 2 1e30\n", ", line 8");
    expectRefused(folder / "f.vtk",
                  "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n1 2 nan\n",
                  ", line 6");
    expectRefused(
        folder / "g.stl",
        "solid s\nfacet\nouter loop\nvertex 0 0 1e11\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
        "endsolid\n",
        ", line 4");
    writeBytes(folder / "earth.xyz", "6378137000 0 -6356752314\n1 2 3\n");
    EXPECT_TRUE(readGeometry(folder / "earth.xyz")) << "the Earth in millimetres";
}

/// PCL marks the holes of a grid with not-a-number; they are no points, in no format they are a place.
TEST(Malformed, HolesOfPcdAreLeftOutAndCounted) {
    const TemporaryFolder folder;
    writeBytes(folder / "a.pcd", kPcdHead + "POINTS 3\nDATA ascii\n1 2 3\nnan nan nan\ninf 2 3\n");
    const LoadedGeometry loaded = readOrFail(folder / "a.pcd");
    EXPECT_EQ(loaded.geometry.vertices.size(), 1);
    EXPECT_EQ(loaded.info.warnings, std::vector<std::string>{"2 points without finite coordinates left out"});
}

TEST(Malformed, AbsurdGridsOfLasAreRefused) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeGeometry(folder / "whole.las", {fullCloud(4, true), {}}));
    const std::string whole = readBytes(folder / "whole.las");
    const auto patched = [&](std::size_t at, double value) {
        std::string content = whole;
        return content.replace(at, 8, std::string(reinterpret_cast<const char*>(&value), 8));
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    for (const double scale : {0.0, nan, inf, -inf, 1e300, 1e-300, 1e7})
        expectRefused(folder / "scale.las", patched(139, scale), ", byte 131");
    for (const double offset : {nan, inf, 1e30, -1e11})
        expectRefused(folder / "offset.las", patched(163, offset), ", byte 155");
    // Each by itself could be; together they lead off the Earth.
    expectRefused(folder / "far.las", patched(131, 1e5), "");
    const auto info = fileInfo(folder / "far.las");
    ASSERT_FALSE(info);
    EXPECT_EQ(info.error().code, ErrorCode::input);
}

TEST(Malformed, ForeignNamesAreToldCleanAndShort) {
    const TemporaryFolder folder;
    std::string head = "ply\nformat ascii 1.0\nelement vertex 1\n" + kXyz;
    for (int i = 0; i < 500; ++i) head += "property uchar \x1b[2J\xff" + std::to_string(i) + "\n";
    std::string row = "1 2 3";
    for (int i = 0; i < 500; ++i) row += " 0";
    writeBytes(folder / "a.ply", head + "end_header\n" + row + "\n");
    const LoadedGeometry loaded = readOrFail(folder / "a.ply");
    ASSERT_EQ(loaded.info.warnings.size(), 1);
    EXPECT_TRUE(loaded.info.warnings[0].starts_with("not kept: ?[2J?0, ?[2J?1, ")) << loaded.info.warnings[0];
    EXPECT_TRUE(loaded.info.warnings[0].ends_with(" and 480 more"));
}

/// A column named again and again was looked for in all columns before it: the square of the header's size.
TEST(Malformed, ManyColumnsOfOneNameTakeNoTime) {
    const TemporaryFolder folder;
    std::string head = "ply\nformat ascii 1.0\nelement vertex 1\n" + kXyz;
    for (int i = 0; i < 200000; ++i) head += "property float intensity\n";
    writeBytes(folder / "a.ply", head + "end_header\n");
    EXPECT_LT(secondsOf([&] { EXPECT_FALSE(readGeometry(folder / "a.ply")); }), 2);
}

TEST(Malformed, ALazFileCannotPromiseMoreThanAScanPacksTo) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeGeometry(folder / "whole.laz", {fullCloud(40, true), {}}));
    std::string content = readBytes(folder / "whole.laz");
    content.replace(247, 8, std::string("\0\0\0\0\1\0\0\0", 8));  // 4 294 967 296 points
    expectRefused(folder / "bomb.laz", content, ", byte 247");
    EXPECT_LT(peakMegabytes(), 500);
}

TEST(Malformed, LinksLeadToFilesAndNothingElse) {
    const TemporaryFolder folder;
    writeBytes(folder / "a.xyz", "1 2 3\n");
    std::filesystem::create_symlink(folder / "a.xyz", folder / "link.xyz");
    std::filesystem::create_symlink("/dev/zero", folder / "zero.xyz");
    std::filesystem::create_symlink(folder / "loop.xyz", folder / "loop.xyz");
    std::filesystem::create_symlink(folder / "missing", folder / "broken.xyz");
    EXPECT_TRUE(readGeometry(folder / "link.xyz"));
    for (const char* name : {"zero.xyz", "loop.xyz", "broken.xyz"}) {
        const auto refused = readGeometry(folder / name);
        ASSERT_FALSE(refused) << name;
        EXPECT_EQ(refused.error().code, ErrorCode::input);
        EXPECT_EQ(refused.error().place, (folder / name).string());
    }
}

TEST(Malformed, LazipsOwnRecordsAreCheckedBeforeItSeesThem) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeGeometry(folder / "whole.laz", {fullCloud(40, true), {}}));
    const std::string whole = readBytes(folder / "whole.laz");
    // Header 375 bytes, record header 54, then LASzip's record; two items of 6 bytes end it.
    const std::size_t record = 375 + 54;
    const std::size_t points = record + 34 + 12;
    const auto patched = [&](std::size_t at, const std::string& bytes) {
        std::string content = whole;
        return content.replace(at, bytes.size(), bytes);
    };
    const auto byte = [](std::size_t at) { return ", byte " + std::to_string(at); };
    expectRefused(folder / "compressor.laz", patched(record, "\7"), byte(record));
    expectRefused(folder / "item.laz", patched(record + 34, "\6"), byte(record + 34));
    expectRefused(folder / "version.laz", patched(record + 34 + 4, "\11"), byte(record + 34));
    expectRefused(folder / "items.laz", patched(record + 32, "\5"), byte(record + 32));
    expectRefused(folder / "table.laz", patched(points + 4, "\377\377\377\77"), byte(points));
    const std::size_t layers = points + 8 + 36 + 4;
    expectRefused(folder / "layer.laz", patched(layers, "\377\377\377\377"), byte(points + 8));
    expectRefused(folder / "count.laz", patched(247, "\51"), byte(points));
    expectRefused(folder / "record.laz", patched(375 + 2, "LASZIP"), byte(375));
}

TEST(Malformed, MissingFilesAndFoldersAreRefused) {
    const TemporaryFolder folder;
    expectReadOrRefused(folder / "missing.las");
    EXPECT_FALSE(readGeometry(folder / "missing.las"));
    EXPECT_FALSE(readGeometry(folder.path()));
    EXPECT_FALSE(readGeometry("/dev/zero"));
}
