#include <gtest/gtest.h>

#include <set>

#include "tests/core/io/Clouds.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

FileInfo peekOrFail(const std::filesystem::path& file) {
    Result<FileInfo> peeked = peekFile(file);
    if (!peeked) {
        ADD_FAILURE() << peeked.error().sentence();
        return {};
    }
    return std::move(*peeked);
}

}  // namespace

TEST(Peek, TellsWhatReadingFindsForRealFiles) {
    VESTIGE_SHARED_OR_SKIP(formats, "formats");
    const std::set<std::string> extensions{".ply", ".pcd", ".stl", ".vtk"};
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(formats)) {
        if (!entry.is_regular_file() || !extensions.contains(entry.path().extension())) continue;
        const Result<LoadedGeometry> read = readGeometry(entry.path());
        if (!read) continue;
        const FileInfo peeked = peekOrFail(entry.path());
        if (peeked.points == 0 && peeked.version == "ascii") continue;  // a text STL has no count
        ++files;
        EXPECT_EQ(peeked.format, read->info.format) << entry.path();
        EXPECT_EQ(peeked.attributes, read->info.attributes) << entry.path();
        if (entry.path().extension() == ".stl") {
            EXPECT_EQ(peeked.triangles, read->info.triangles) << entry.path();
        } else {
            // Points without finite coordinates are left out when they are read.
            EXPECT_GE(peeked.points, read->info.points) << entry.path();
            if (read->info.warnings.empty()) {
                EXPECT_EQ(peeked.points, read->info.points) << entry.path();
            }
        }
    }
    EXPECT_GT(files, 10);
}

TEST(Peek, TellsWhatWasWritten) {
    const TemporaryFolder folder;
    const TriangleMesh mesh{fullCloud(40, true), {{0, 1, 2}, {2, 3, 4}}};
    for (const char* extension : {"ply", "pcd"}) {
        const auto file = folder / (std::string("a.") + extension);
        ASSERT_TRUE(writeGeometry(file, mesh));
        const FileInfo peeked = peekOrFail(file);
        EXPECT_EQ(peeked.points, 40);
        EXPECT_EQ(peeked.attributes, readOrFail(file).info.attributes);
        EXPECT_EQ(peeked.triangles, std::string(extension) == "ply" ? 2 : 0);
        EXPECT_TRUE(peeked.warnings.empty());
        EXPECT_TRUE(peeked.sha256.empty());
    }
}

TEST(Peek, NeverPromisesMoreThanTheFileHasRoomFor) {
    const TemporaryFolder folder;
    const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
    const std::pair<const char*, std::string> kLies[] = {
        {"a.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000000\n" + xyz +
                      "element face 900000000000\nproperty list uchar int vertex_indices\nend_header\nxxxx"},
        {"b.ply", "ply\nformat ascii 1.0\nelement vertex 900000000\n" + xyz + "end_header\n1 2 3\n"},
        {"a.pcd",
         "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nPOINTS 800000000000\nDATA "
         "ascii\n1"},
        {"a.stl", std::string(80, ' ') + std::string("\xff\xff\xff\x7f", 4) + std::string(120, 'x')},
        {"a.vtk", "# vtk DataFile Version 3.0\nt\nBINARY\nDATASET POLYDATA\nPOINTS 900000000 float\nxx"}};
    for (const auto& [name, content] : kLies) {
        writeBytes(folder / name, content);
        const FileInfo peeked = peekOrFail(folder / name);
        EXPECT_LE(peeked.points, 6) << name;
        EXPECT_LE(peeked.triangles, 5) << name;
    }
}

TEST(Peek, OfBrokenFilesIsASentenceOrLittle) {
    VESTIGE_SHARED_OR_SKIP(folder, "malformed");
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file()) continue;
        const Result<FileInfo> peeked = peekFile(entry.path());
        if (peeked) {
            EXPECT_LE(peeked->points, entry.file_size()) << entry.path();
        } else {
            EXPECT_EQ(peeked.error().code, ErrorCode::input) << entry.path();
        }
    }
}
