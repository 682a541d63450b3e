#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace vestige {

/// CRC-32C (Castagnoli; RFC 3720, B.4) by the processor's own instruction, which is part of the instruction
/// set that Vestige asks for (decision 0006).
std::uint32_t crc32c(std::span<const std::byte> bytes);

}  // namespace vestige
