#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace vestige {

/// Unpacks LZF (Lehmann's LibLZF format, used by PCD's binary_compressed): runs of literals and references
/// back into the output. Fewer than `size` bytes where the data are damaged from some place on or end early.
std::vector<std::byte> unpackLzf(std::span<const std::byte> packed, std::size_t size);

}  // namespace vestige
