#include "tests/core/io/TileFiles.h"

#include <cstdint>

namespace vestige::test {

std::string pntsBytes(std::string featureJson, std::string featureBinary, std::string batchJson,
                      std::string batchBinary) {
    const auto padTo = [](std::string& text, std::size_t before, char with) {
        while ((before + text.size()) % 8 != 0) text += with;
    };
    padTo(featureJson, 28, ' ');
    padTo(featureBinary, 0, '\0');
    padTo(batchJson, 0, ' ');
    padTo(batchBinary, 0, '\0');
    const auto size = [](const std::string& text) { return static_cast<std::uint32_t>(text.size()); };
    return "pnts" +
           bytesOf<std::uint32_t>(
               {1, 28 + size(featureJson) + size(featureBinary) + size(batchJson) + size(batchBinary),
                size(featureJson), size(featureBinary), size(batchJson), size(batchBinary)}) +
           featureJson + featureBinary + batchJson + batchBinary;
}

}  // namespace vestige::test
