#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/formats/GltfJson.h"

namespace vestige {

/// The two parts of a .glb file, or the text of a .gltf file.
struct GltfContainer {
    std::string_view json;
    std::size_t jsonByte = 0;  ///< where it begins in the file
    bool isBinary = false;
    std::uint64_t binaryByte = 0, binaryLength = 0;  ///< the BIN chunk; length 0: none
};

/// Where a buffer's bytes are: in a file, or decoded from the document.
struct GltfBuffer {
    std::filesystem::path file;
    std::uint64_t offset = 0;
    std::uint64_t length = 0;
    std::optional<std::string> decoded;
};

/// By glTF 2.0 section 4.4. Refuses at the byte where header or chunks do not hold.
GltfContainer splitGltf(std::span<const std::byte> file, const ReadJob& job);

/// The buffers `used` of the document, each with at least as many bytes as it promises. A buffer beside the
/// document must lie in its folder or below, symbolic links followed; addresses of any other kind are
/// refused.
std::vector<GltfBuffer> findGltfBuffers(const GltfJson& document, const GltfContainer& container,
                                        const std::vector<std::uint64_t>& used);

}  // namespace vestige
