#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace vestige {

/// Unpacks LZF (Lehmann's LibLZF format, used by PCD's binary_compressed): runs of literals and references
/// back into the output. Nothing unless the data are sound and give exactly `size` bytes.
std::optional<std::vector<std::byte>> unpackLzf(std::span<const std::byte> packed, std::size_t size);

}  // namespace vestige
