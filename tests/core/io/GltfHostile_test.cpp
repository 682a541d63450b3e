#include <gtest/gtest.h>

#include "tests/core/io/GltfText.h"
#include "tests/core/io/Hostile.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

const std::string kCorners = bytesOf<float>({0, 0, 0, 2, 0, 0, 0, 3, 0.5});

std::string accessor(const std::string& facts) {
    return R"("accessors":[{)" + facts + "}],";
}
const std::string kView = R"("bufferViews":[{"buffer":0,"byteLength":36}],)";
const std::string kPosition = accessor(R"("bufferView":0,"componentType":5126,"count":3,"type":"VEC3")");
const std::string kMesh = R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}])";
const std::string kNode = R"(,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}])";

}  // namespace

TEST(GltfHostile, SharedFilesAreReadOrRefused) {
    VESTIGE_SHARED_OR_SKIP(folder, "malformed/assimp/test/models/glTF2");
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".gltf" && entry.path().extension() != ".glb") continue;
        ++files;
        expectReadOrRefused(entry.path());
    }
    EXPECT_GT(files, 15);
}

TEST(GltfHostile, BuffersOutsideOfTheFolderAreNotTouched) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "in");
    writeBytes(folder / "secret.bin", kCorners);
    std::filesystem::create_symlink(folder / "secret.bin", folder / "in/link.bin");
    std::filesystem::create_directory_symlink(folder.path(), folder / "in/up");
    const auto document = [&](const std::string& address) {
        return R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":36,"uri":")" + address + "\"}]," +
               kView + kPosition + kMesh + kNode + "}";
    };
    const auto file = folder / "in/a.gltf";
    for (const std::string& address :
         {(folder / "secret.bin").string(), std::string("../secret.bin"), std::string("%2e%2e/secret.bin"),
          std::string("x/../../secret.bin"), std::string("http://example.org/a.bin"),
          std::string("file:///etc/passwd"), std::string("..\\\\secret.bin"), std::string("a%00b")})
        expectRefusedWith(file, document(address), "names the buffer");
    expectRefusedWith(file, document("link.bin"), "leads out of the document's folder");
    expectRefusedWith(file, document("up/secret.bin"), "leads out of the document's folder");
    expectRefusedWith(file, document("missing.bin"), "missing");
    expectRefusedWith(file, document("up"), "missing");
}

TEST(GltfHostile, PromisesThatTheFileCannotKeepAreRefused) {
    const TemporaryFolder folder;
    const auto file = folder / "a.gltf";
    const auto refused = [&](const std::string& rest, const std::string& words) {
        expectRefusedWith(file, gltfText(kCorners, rest), words);
    };
    refused(
        kView + accessor(R"("bufferView":0,"componentType":5126,"count":4,"type":"VEC3")") + kMesh + kNode,
        "leaves buffer view 0");
    refused(kView + accessor(R"("bufferView":0,"componentType":5126,"count":4000000000,"type":"VEC3")") +
                kMesh + kNode,
            "leaves buffer view 0");
    refused(kView + accessor(R"("componentType":5126,"count":4000000000,"type":"VEC3")") + kMesh + kNode,
            "names no buffer view");
    refused(
        kView +
            accessor(R"("bufferView":0,"componentType":5126,"count":18446744073709551615,"type":"VEC3")") +
            kMesh + kNode,
        "items");
    refused(
        kView +
            accessor(
                R"("bufferView":0,"byteOffset":18446744073709551610,"componentType":5126,"count":3,"type":"VEC3")") +
            kMesh + kNode,
        "leaves buffer view 0");
    refused(
        kView + accessor(R"("bufferView":7,"componentType":5126,"count":3,"type":"VEC3")") + kMesh + kNode,
        "names item 7 of 'bufferViews'");
    refused(
        kView + accessor(R"("bufferView":0,"componentType":5126,"count":-3,"type":"VEC3")") + kMesh + kNode,
        "'count'");
    refused(kView +
                accessor(R"("bufferView":0,"componentType":5122,"count":3,"type":"VEC3","normalized":true)") +
                kMesh + kNode,
            "not float vectors");
    refused(R"("bufferViews":[{"buffer":0,"byteOffset":4,"byteLength":36}],)" + kPosition + kMesh + kNode,
            "leaves its buffer");
    refused(R"("bufferViews":[{"buffer":0,"byteLength":36,"byteStride":4}],)" + kPosition + kMesh + kNode,
            "stride of 4");
    refused(
        kView + kPosition + R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":9}]}])" + kNode,
        "mode 9");
    refused(kView + kPosition + kMesh + R"(,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":1}])",
            "names item 1 of 'meshes'");
    refused(kView + kPosition + kMesh +
                R"(,"scenes":[{"nodes":[0]}],"nodes":[{"children":[1]},{"children":[0]}])",
            "twice or holds itself");
    refused(
        kView + kPosition + kMesh + R"(,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"rotation":[0,0,0,0]}])",
        "rotation");
    refused(
        kView + kPosition + kMesh +
            R"(,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"translation":[0,0,1e308],"scale":[1,1,1e308],"children":[]}],"x":[1e999])",
        "number");
    expectRefusedWith(
        file,
        R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":36,"uri":"data:a;base64,AAAA"}],)" + kView +
            kPosition + kMesh + kNode + "}",
        "has 3 bytes");
    expectRefusedWith(
        file,
        R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":3,"uri":"data:a;base64,A A="}],)" + kView +
            kPosition + kMesh + kNode + "}",
        "leaves its buffer");
    expectRefusedWith(file, R"({"asset":{"version":"1.0"}})", "version '1.0'");
    expectRefusedWith(file,
                      "{\"asset\":{\"version\":\"2.0\"},\"scenes\":" + std::string(100000, '[') +
                          std::string(100000, ']') + "}",
                      "nested too deep");
    for (const char* extension :
         {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_mesh_quantization"})
        refused(kView + kPosition + kMesh + kNode + R"(,"extensionsRequired":[")" + extension + "\"]",
                extension);
}

TEST(GltfHostile, IndicesBeyondTheVerticesAreRefused) {
    const TemporaryFolder folder;
    const std::string rest =
        R"("bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":12}],"accessors":[)"
        R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},)"
        R"({"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"}],)"
        R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}])" +
        kNode;
    expectRefusedWith(folder / "a.gltf",
                      gltfText(kCorners + bytesOf<std::uint16_t>({0, 1, 2, 0, 1, 3}), rest), "1 can be read");
    expectRefusedWith(folder / "b.gltf",
                      gltfText(kCorners + bytesOf<std::uint16_t>({0, 1, 65535, 7, 8, 9}), rest), "");
}

TEST(GltfHostile, CopiesWithoutEndAreRefused) {
    const TemporaryFolder folder;
    // 3000 vertices, in 1500 primitives that share them, in 1500 nodes.
    const auto document = [&](int primitives, int nodes) {
        std::string shapes, places, roots;
        for (int i = 0; i < primitives; ++i)
            shapes += std::string(i ? "," : "") + R"({"attributes":{"POSITION":0}})";
        for (int i = 0; i < nodes; ++i) {
            places += std::string(i ? "," : "") + R"({"mesh":0})";
            roots += std::string(i ? "," : "") + std::to_string(i);
        }
        return gltfText(
            std::string(36000, '\0'),
            R"("bufferViews":[{"buffer":0,"byteLength":36000}],"accessors":[{"bufferView":0,"componentType":5126,"count":3000,"type":"VEC3"}],)"
            R"("meshes":[{"primitives":[)" +
                shapes + R"(]}],"scenes":[{"nodes":[)" + roots + R"(]}],"nodes":[)" + places + "]");
    };
    expectRefusedWith(folder / "a.gltf", document(1500, 1500), "without end");
    expectRefusedWith(folder / "b.gltf", document(5000, 1), "repeats its vertices");
    expectRefusedWith(folder / "c.gltf", document(1, 5000), "repeats its vertices");
}

TEST(GltfHostile, TrianglesRepeatedWithoutEndAreRefused) {
    const TemporaryFolder folder;
    // Three vertices and 10000 triangles, in `primitives` that share them or at `nodes`.
    const auto document = [&](int primitives, int nodes) {
        std::string shapes, places, roots;
        for (int i = 0; i < primitives; ++i)
            shapes += std::string(i ? "," : "") + R"({"attributes":{"POSITION":0},"indices":1})";
        for (int i = 0; i < nodes; ++i) {
            places += std::string(i ? "," : "") + R"({"mesh":0})";
            roots += std::string(i ? "," : "") + std::to_string(i);
        }
        return gltfText(
            kCorners + std::string(30000, '\1'),
            R"("bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":30000}],"accessors":[)"
            R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},)"
            R"({"bufferView":1,"componentType":5121,"count":30000,"type":"SCALAR"}],)"
            R"("meshes":[{"primitives":[)" +
                shapes + R"(]}],"scenes":[{"nodes":[)" + roots + R"(]}],"nodes":[)" + places + "]");
    };
    expectRefusedWith(folder / "a.gltf", document(1, 2500), "repeats its triangles");
    expectRefusedWith(folder / "b.gltf", document(2500, 1), "repeats its triangles");
    writeBytes(folder / "c.gltf", document(1, 2));
    EXPECT_EQ(readOrFail(folder / "c.gltf").info.triangles, 20000);
}

TEST(GltfHostile, TruncatedAndFlippedFilesAreReadOrRefused) {
    const TemporaryFolder folder;
    TriangleMesh mesh{fullCloud(30, true), {{0, 1, 2}, {3, 4, 5}}};
    ASSERT_TRUE(writeGeometry(folder / "whole.glb", mesh));
    const std::string whole = readBytes(folder / "whole.glb");
    for (std::size_t length = 4; length < whole.size(); length += 97) {
        writeBytes(folder / "cut.glb", whole.substr(0, length));
        const Result<LoadedGeometry> loaded = readGeometry(folder / "cut.glb");
        ASSERT_FALSE(loaded) << length;
        EXPECT_NE(loaded.error().place.find(", byte "), std::string::npos) << loaded.error().sentence();
    }
    for (std::size_t at = 0; at < whole.size(); at += 23) {
        std::string flipped = whole;
        flipped[at] = static_cast<char>(flipped[at] ^ (1 << at % 8));
        writeBytes(folder / "flipped.glb", flipped);
        expectReadOrRefused(folder / "flipped.glb");
    }
}
