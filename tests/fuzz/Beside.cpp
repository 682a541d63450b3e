#include "tests/fuzz/Beside.h"

#include <fstream>

#include "tests/core/io/S3mbFiles.h"
#include "tests/core/io/TileFiles.h"

namespace vestige::fuzz {
namespace {

void put(const std::filesystem::path& file, const std::string& content) {
    std::ofstream(file, std::ios::binary) << content;
}

}  // namespace

void putBeside(const std::string& extension, const std::filesystem::path& folder) {
    if (extension == "json") {
        put(folder / "tile.pnts", test::pntsOf({{1, 2, 3}, {4, 5, 6}}));
        put(folder / "more.json", test::tilesetJson(R"("refine":"ADD","content":{"uri":"tile.pnts"})"));
    }
    if (extension == "scp") {
        test::S3mbPoints part;
        part.positions = {{1, 2, 3}};
        put(folder / "tile.s3mb", test::s3mbFile(test::s3mbPackage({part})));
    }
    if (extension == "gltf") put(folder / "buffer.bin", std::string(256, '\1'));
}

}  // namespace vestige::fuzz
