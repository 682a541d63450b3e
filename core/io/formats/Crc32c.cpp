#include "core/io/formats/Crc32c.h"

#include <nmmintrin.h>

#include <cstring>

namespace vestige {

std::uint32_t crc32c(std::span<const std::byte> bytes) {
    std::uint64_t sum = 0xffffffff;
    const std::byte* at = bytes.data();
    std::size_t left = bytes.size();
    for (; left >= 8; at += 8, left -= 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, at, 8);
        sum = _mm_crc32_u64(sum, word);
    }
    auto rest = static_cast<std::uint32_t>(sum);
    for (; left > 0; ++at, --left) rest = _mm_crc32_u8(rest, static_cast<std::uint8_t>(*at));
    return ~rest;
}

}  // namespace vestige
