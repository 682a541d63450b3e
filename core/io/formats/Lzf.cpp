#include "core/io/formats/Lzf.h"

#include <algorithm>

namespace vestige {
namespace {

/// Three bytes can stand for at most 264, so a larger promise is false and needs no memory.
constexpr std::size_t kLargestGrowth = 88;

}  // namespace

std::vector<std::byte> unpackLzf(std::span<const std::byte> packed, std::size_t size) {
    size = std::min(size, kLargestGrowth * (packed.size() + 1));
    std::vector<std::byte> out;
    out.reserve(size);
    std::size_t at = 0;
    while (at < packed.size()) {
        const auto control = std::to_integer<std::size_t>(packed[at++]);
        if (control < 32) {
            const std::size_t length = control + 1;
            if (packed.size() - at < length || size - out.size() < length) return out;
            out.insert(out.end(), packed.begin() + static_cast<std::ptrdiff_t>(at),
                       packed.begin() + static_cast<std::ptrdiff_t>(at + length));
            at += length;
            continue;
        }
        std::size_t length = control >> 5;
        if (length == 7) {
            if (at == packed.size()) return out;
            length += std::to_integer<std::size_t>(packed[at++]);
        }
        length += 2;
        if (at == packed.size()) return out;
        const std::size_t back = ((control & 31) << 8) + std::to_integer<std::size_t>(packed[at++]) + 1;
        if (back > out.size() || size - out.size() < length) return out;
        // Byte by byte: a reference may overlap what it writes.
        for (std::size_t i = 0; i < length; ++i) out.push_back(out[out.size() - back]);
    }
    return out;
}

}  // namespace vestige
