#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/io/ReadJob.h"

namespace vestige {

/// Inflates a zlib or gzip stream to exactly `size` bytes. More than 256 times the stream, which measured
/// points never reach, and more than `largest` is refused before memory is taken; so are streams that end
/// early or hold more. `offset` is the stream's place in the job's file.
std::vector<std::byte> inflated(std::span<const std::byte> stream, std::size_t size, std::size_t largest,
                                std::size_t offset, const ReadJob& job);

}  // namespace vestige
