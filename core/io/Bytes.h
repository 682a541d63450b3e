#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

namespace vestige {

/// A number from raw bytes of the given byte order; `at` need not be aligned.
template <class Number>
Number load(const std::byte* at, std::endian order = std::endian::little) {
    std::byte raw[sizeof(Number)];
    for (std::size_t i = 0; i < sizeof(Number); ++i)
        raw[i] = at[order == std::endian::native ? i : sizeof(Number) - 1 - i];
    Number value;
    std::memcpy(&value, raw, sizeof(Number));
    return value;
}

/// Little endian, as every format that Vestige writes has it.
template <class Number>
void store(std::byte* at, Number value) {
    std::memcpy(at, &value, sizeof(Number));
    if constexpr (std::endian::native == std::endian::big)
        for (std::size_t i = 0; i < sizeof(Number) / 2; ++i) std::swap(at[i], at[sizeof(Number) - 1 - i]);
}

}  // namespace vestige
