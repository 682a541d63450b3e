#include "core/io/InputHash.h"

#include <gtest/gtest.h>

#include "core/base/Hash.h"
#include "tests/core/io/Clouds.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

/// What `sha256sum` would tell of some text.
std::string sha256Of(const std::string& text) {
    Sha256 sha;
    sha.add(text);
    return sha.hex();
}

std::string hashOf(const std::filesystem::path& file) {
    const auto info = fileInfo(file);
    EXPECT_TRUE(info) << info.error().sentence();
    return info ? info->sha256 : std::string();
}

}  // namespace

TEST(InputHash, OfASingleFileIsItsOwn) {
    const TemporaryFolder folder;
    writeBytes(folder / "a.xyz", "1 2 3\n4 5 6\n");
    EXPECT_EQ(hashOf(folder / "a.xyz"), sha256Of("1 2 3\n4 5 6\n"));
}

TEST(InputHash, OfSeveralIsThatOfTheListThatSha256sumPrints) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "tiles");
    writeBytes(folder / "index.json", "index");
    writeBytes(folder / "tiles/b.pnts", "second");
    writeBytes(folder / "a.pnts", "first");
    const auto input = hashInput(folder / "index.json", {folder / "tiles/b.pnts", folder / "a.pnts"});
    ASSERT_TRUE(input) << input.error().sentence();
    EXPECT_EQ(input->sha256, sha256Of(sha256Of("index") + "  index.json\n" + sha256Of("first") +
                                      "  a.pnts\n" + sha256Of("second") + "  tiles/b.pnts\n"));
    EXPECT_EQ(input->companions, (std::vector<std::string>{sha256Of("second"), sha256Of("first")}));
    EXPECT_FALSE(hashInput(folder / "index.json", {folder / "missing.pnts"}));
}

TEST(InputHash, OfATilesetAndOfAGltfSceneCoversWhatTheyName) {
    VESTIGE_SHARED_OR_SKIP(tile, "formats/pnts/PointCloud/PointCloudRGB/pointCloudRGB.pnts");
    const TemporaryFolder folder;
    std::filesystem::copy_file(tile, folder / "a.pnts");
    writeBytes(folder / "tileset.json",
               R"({"asset":{"version":"1.0"},"root":{"refine":"ADD","content":{"uri":"a.pnts"}}})");
    const std::string before = hashOf(folder / "tileset.json");
    EXPECT_NE(before, sha256Of(readBytes(folder / "tileset.json")));
    std::string bytes = readBytes(folder / "a.pnts");
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    writeBytes(folder / "a.pnts", bytes);
    EXPECT_NE(hashOf(folder / "tileset.json"), before);

    // One triangle, its corners in a buffer beside the scene.
    const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::string buffer(reinterpret_cast<const char*>(corners), sizeof corners);
    writeBytes(folder / "a.bin", buffer);
    writeBytes(
        folder / "a.gltf",
        R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
        R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
        R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],)"
        R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"uri":"a.bin","byteLength":36}]})");
    EXPECT_EQ(hashOf(folder / "a.gltf"), sha256Of(sha256Of(readBytes(folder / "a.gltf")) + "  a.gltf\n" +
                                                  sha256Of(buffer) + "  a.bin\n"));
}
