#include <sys/resource.h>

#include <gtest/gtest.h>

#include <chrono>

#include "tests/core/io/Clouds.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

double secondsOf(const auto& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
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
