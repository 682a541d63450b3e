#include <gtest/gtest.h>

#include "core/base/Random.h"
#include "tests/core/io/Clouds.h"
#include "tests/core/io/TileFiles.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

const std::string kPoint = pntsOf({{1, 2, 3}});

std::string content(const std::string& uri) {
    return R"("refine":"ADD","content":{"uri":")" + uri + "\"}";
}

void expectRefused(const std::filesystem::path& file, const std::string& text, const std::string& part) {
    writeBytes(file, text);
    const Result<LoadedGeometry> loaded = readGeometry(file);
    ASSERT_FALSE(loaded) << text.substr(0, 300);
    EXPECT_EQ(loaded.error().code, ErrorCode::input);
    EXPECT_NE(loaded.error().sentence().find(part), std::string::npos) << loaded.error().sentence();
    EXPECT_NE(loaded.error().hint.find("expected: "), std::string::npos) << loaded.error().sentence();
}

}  // namespace

TEST(TilesetHostile, NothingOutsideItsFolderIsRead) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "in/side");
    writeBytes(folder / "secret.pnts", kPoint);
    writeBytes(folder / "insider.pnts", kPoint);
    writeBytes(folder / "in/a.pnts", kPoint);
    std::filesystem::create_symlink(folder / "secret.pnts", folder / "in/link.pnts");
    std::filesystem::create_directory_symlink(folder.path(), folder / "in/way");
    std::filesystem::create_symlink("a.pnts", folder / "in/fine.pnts");
    const auto file = folder / "in/tileset.json";
    for (const char* uri : {"../secret.pnts", "..%2Fsecret.pnts", "%2e%2e/secret.pnts", "..\\\\secret.pnts",
                            "side/../../secret.pnts", "link.pnts", "way/secret.pnts", "way/in/../secret.pnts",
                            "../in/../insider.pnts"})
        expectRefused(file, tilesetJson(content(uri)), "lies outside the folder");
    const std::string absolute = (folder / "in/a.pnts").string();
    expectRefused(file, tilesetJson(content(absolute)), "absolute path");
    expectRefused(file, tilesetJson(content("%2Fetc/passwd")), "absolute path");
    for (const char* uri : {"http://127.0.0.1/a.pnts", "https:a.pnts", "file:///etc/passwd",
                            "data:application/octet-stream;base64,cG50cw==", "//host/a.pnts", "C:/a.pnts"})
        expectRefused(file, tilesetJson(content(uri)), "is not a file beside it");
    expectRefused(file, tilesetJson(content("")), "no file name");
    expectRefused(file, tilesetJson(content("a.pnts%00.json")), "no file name");
    expectRefused(file, tilesetJson(content(std::string(10000, 'a'))), "the tile 'aaa");
    expectRefused(file, tilesetJson(content("side")), "is no file");
    expectRefused(file, tilesetJson(content("none.pnts")), "is missing");
    writeBytes(file, tilesetJson(content("fine.pnts")));
    EXPECT_EQ(readOrFail(file).info.points, 1);
    // A nested tileset may not leave the folder of the root, but need not stay in its own.
    writeBytes(folder / "in/side/next.json", tilesetJson(content("../../secret.pnts")));
    expectRefused(file, tilesetJson(content("side/next.json")), "lies outside the folder");
}

TEST(TilesetHostile, EveryFileIsReadOnceSoThatNothingGoesRound) {
    const TemporaryFolder folder;
    const auto file = folder / "tileset.json";
    writeBytes(folder / "a.pnts", kPoint);
    expectRefused(file, tilesetJson(content("tileset.json")), "named a second time");
    writeBytes(folder / "b.json", tilesetJson(content("tileset.json")));
    expectRefused(file, tilesetJson(content("b.json")), "named a second time");
    expectRefused(file, tilesetJson(R"("refine":"ADD","contents":[{"uri":"a.pnts"},{"uri":"./a.pnts"}])"),
                  "named a second time");
    for (int i = 0; i < 40; ++i)
        writeBytes(folder / ("n" + std::to_string(i) + ".json"),
                   tilesetJson(content(i < 39 ? "n" + std::to_string(i + 1) + ".json" : "a.pnts")));
    expectRefused(file, tilesetJson(content("n0.json")), "nested too deep");
    writeBytes(file, tilesetJson(content("n20.json")));
    EXPECT_EQ(readOrFail(file).info.points, 1);
}

TEST(TilesetHostile, WhatIsNotUnderstoodIsRefused) {
    const TemporaryFolder folder;
    const auto file = folder / "tileset.json";
    writeBytes(folder / "a.pnts", kPoint);
    writeBytes(folder / "a.b3dm", "b3dm");
    writeBytes(folder / "a.bin", "????");
    writeBytes(folder / "empty.pnts", "");
    expectRefused(file, R"({"asset":{},"root":{"implicitTiling":{"subdivisionScheme":"OCTREE"}}})",
                  "implicitly");
    expectRefused(file, tilesetJson(R"("extensions":{"3DTILES_implicit_tiling":{}})"), "implicitly");
    expectRefused(file, tilesetJson(R"("transform":[1,2,3],)" + content("a.pnts")), "no matrix");
    expectRefused(file, tilesetJson(R"("transform":[0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1],)" + content("a.pnts")),
                  "invertible");
    expectRefused(file, tilesetJson(R"("transform":[1,0,0,1,0,1,0,0,0,0,1,0,0,0,0,1],)" + content("a.pnts")),
                  "last row");
    expectRefused(file,
                  tilesetJson(R"("transform":[1,0,0,0,0,1,0,0,0,0,1,0,1e308,0,0,1],"children":[{)" +
                              std::string(R"("transform":[1,0,0,0,0,1,0,0,0,0,1,0,1e308,0,0,1],)") +
                              content("a.pnts") + "}]"),
                  "no finite number");
    expectRefused(file, tilesetJson(R"("refine":"MERGE")"), "refines by 'MERGE'");
    expectRefused(file, tilesetJson(R"("refine":"ADD","content":{"src":"a"})"), "names no file");
    expectRefused(file, tilesetJson(R"("refine":"ADD","children":{})"), "no list");
    expectRefused(file, tilesetJson(R"("refine":"ADD","children":[1])"), "root.children[0]");
    expectRefused(file, tilesetJson(""), "names no point tiles");
    expectRefused(file, tilesetJson(content("a.b3dm")), "b3dm");
    expectRefused(file, tilesetJson(content("a.bin")), "no tile of a known kind");
    expectRefused(file, tilesetJson(content("empty.pnts")), "no tile of a known kind");
    expectRefused(file, R"({"asset":{},"root":[]})", "no tileset");
    expectRefused(file, R"({"vestige":1,"layers":[]})", "a Vestige case");
    expectRefused(file, R"({"some":"thing"})", "no tileset");
    expectRefused(file, tilesetJson(R"("x":)" + std::string(3000, '[') + std::string(3000, ']')),
                  "nested 3002");
}

TEST(TilesetHostile, DamagedTextIsReadOrRefused) {
    const TemporaryFolder folder;
    const auto file = folder / "tileset.json";
    writeBytes(folder / "1.pnts", kPoint);
    writeBytes(folder / "2.pnts", kPoint);
    const std::string whole =
        tilesetJson(R"("refine":"REPLACE",)" + transformJson(eastNorthUp(8, 50, 100)) +
                    R"(,"content":{"uri":"1.pnts"},"children":[{"content":{"uri":"2.pnts"}}])");
    for (std::size_t length = 0; length < whole.size(); length += 3) {
        writeBytes(file, whole.substr(0, length));
        EXPECT_FALSE(readGeometry(file)) << length;
    }
    for (std::uint64_t round = 0; round < 300; ++round) {
        Random random(5, round);
        std::string damaged = whole;
        for (std::uint64_t i = 0; i <= random.below(3); ++i)
            damaged[random.below(damaged.size())] = static_cast<char>(random.below(256));
        writeBytes(file, damaged);
        const auto loaded = readGeometry(file);
        if (!loaded) {
            EXPECT_EQ(loaded.error().code, ErrorCode::input);
        }
    }
}

TEST(TilesetHostile, NestedTilesetsDoNotAddUpToADepthWithoutBound) {
    const TemporaryFolder folder;
    const auto deep = [](int tiles, const std::string& leaf) {
        std::string text = leaf;
        for (int i = 1; i < tiles; ++i) text = R"("children":[{)" + text + "}]";
        return tilesetJson(text);
    };
    writeBytes(folder / "a.pnts", kPoint);
    writeBytes(folder / "c.json", deep(100, content("a.pnts")));
    writeBytes(folder / "b.json", deep(100, content("c.json")));
    EXPECT_EQ(readOrFail(folder / "b.json").info.points, 1);
    expectRefused(folder / "a.json", deep(100, content("b.json")), "nested too deep");
    ReadOptions salvage;
    salvage.salvage = true;
    EXPECT_FALSE(readGeometry(folder / "a.json", salvage));
}
