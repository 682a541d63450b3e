#pragma once

#include <cstdint>
#include <vector>

#include "core/io/formats/LasHeader.h"
#include "core/io/formats/laz/ChunkIndex.h"

namespace vestige {

/// How a checked file's compressed points can be read.
struct LazPlan {
    std::uint64_t points = 0;     ///< that are there; fewer than the header says only of a salvaged file
    std::uint64_t chunkSize = 0;  ///< points after which decoding can begin anew; 0: only from the start
    bool variableChunks = false;  ///< chunks of differing size: beginning anew costs some of a chunk
    /// Points of a chunk. Damage within leaves none of them sure: decoding goes on for a while before it
    /// fails. 0: the file is one chunk, or its chunks vary.
    std::uint64_t sureTogether = 0;
    bool withoutTable = false;  ///< salvaged: chunks are found one behind the other
    /// All chunks, where they can be read with LayeredChunk. Empty: only LASzip can read the file.
    std::vector<laz::ChunkPlace> chunks;
    bool asVersion3 = false;  ///< of LASzip's item coders
};

/// Refuses a compressed file whose LASzip record or chunk table does not fit its header or size, and one that
/// promises more points than its bytes can explain. With `salvage`, a file that was cut off is planned as far
/// as its chunks are whole.
LazPlan planLaz(std::span<const std::byte> file, const LasHeader& header, const ReadJob& job, bool salvage);

/// What stands before the points, rewritten from checked values for LASzip: header, LASzip's record, nothing
/// else; as long as in the file, so that places inside the file stay true.
std::vector<std::byte> lazPrefix(std::span<const std::byte> file, const LasHeader& header,
                                 const LazPlan& plan);

}  // namespace vestige
