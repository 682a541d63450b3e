#pragma once

#include <cstddef>
#include <span>

#include "core/io/ReadJob.h"

namespace vestige {

/// What a Draco point stream says before its data.
struct DracoPromise {
    std::size_t points = 0;
    std::size_t bytesPerPoint = 0;  ///< of all attributes, decoded
};

/// Walks over the header and the descriptions of the attributes (Draco bitstream 2.0 to 2.3, point clouds)
/// and refuses what a decoder should not see: other geometry, metadata, more than 64 attributes or 4
/// components, more memory than 512 times the stream and 1 MiB. `offset` is the stream's place in the job's
/// file.
DracoPromise checkDracoStream(std::span<const std::byte> stream, std::size_t offset, const ReadJob& job);

}  // namespace vestige
