#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/io/formats/LasHeader.h"

namespace vestige::laz {

struct ChunkPlace {
    std::uint64_t firstPoint = 0;
    std::size_t begin = 0;  ///< a byte of the file
};

/// What lies in whole chunks of point formats 6 and later, one behind the other from the first.
struct WholeChunks {
    std::vector<ChunkPlace> chunks;
    std::uint64_t points = 0;
    std::size_t end = 0;  ///< the byte behind the last whole chunk
};

/// Layers of a chunk of the header's points (format 6 and later): nine of the point, then those of colour,
/// infrared and wave packet, one for each extra byte.
std::size_t layerCount(const LasHeader& header);

/// Chunk after chunk up to `limit`: a whole point, the number of points, the size of each layer, the layers.
/// Ends where one does not fit, or where a layer begins with what no encoder writes.
WholeChunks wholeChunks(std::span<const std::byte> file, const LasHeader& header, std::size_t limit);

/// Whether no chunk is empty and, with `chunkSize`, all but the last have that many points, the last no more.
bool countsFit(const WholeChunks& whole, std::uint64_t chunkSize);

/// Whether the chunk table, which `table` begins with, names the same chunks. With `counts` it tells of each
/// its points, too.
bool tableAgrees(std::span<const std::byte> table, const WholeChunks& whole, bool counts);

}  // namespace vestige::laz
