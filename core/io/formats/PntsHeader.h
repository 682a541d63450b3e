#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "core/io/ReadJob.h"

namespace vestige {

/// A stretch of a tile's bytes.
struct PntsSection {
    std::size_t begin = 0;
    std::size_t length = 0;
};

/// The 28 bytes that begin a point tile (OGC 3D Tiles 1.0, "Point Cloud"): where its four sections lie.
struct PntsHeader {
    PntsSection featureJson;
    PntsSection featureBinary;
    PntsSection batchJson;
    PntsSection batchBinary;
    bool truncated = false;      ///< the file ends before the tile does
    bool batchTableCut = false;  ///< and before the JSON of its batch table does
};

constexpr std::size_t kPntsHeaderBytes = 28;

/// Refuses a tile whose sections do not fit into its length; unless `salvage`, also one that the file cuts
/// off. Then the binary sections end where the file ends.
PntsHeader parsePntsHeader(std::span<const std::byte> bytes, bool salvage, ReadJob& job);

inline std::string_view textOf(std::span<const std::byte> bytes, const PntsSection& section) {
    return {reinterpret_cast<const char*>(bytes.data()) + section.begin, section.length};
}

}  // namespace vestige
