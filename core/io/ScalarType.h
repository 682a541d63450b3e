#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

namespace vestige {

/// The number types of binary point files.
enum class ScalarType : std::uint8_t {
    int8,
    uint8,
    int16,
    uint16,
    int32,
    uint32,
    int64,
    uint64,
    float32,
    float64
};

std::size_t sizeOf(ScalarType type);
bool isInteger(ScalarType type);

/// The number at `at`, exact except for 64-bit integers above 2^53.
double readScalar(ScalarType type, const std::byte* at, std::endian order = std::endian::little);
/// Little endian; integers are rounded and kept inside the range of the type.
void writeScalar(ScalarType type, double value, std::byte* at);

}  // namespace vestige
