#include "core/io/ScalarType.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/io/Bytes.h"

namespace vestige {
namespace {

/// Calls `work` with a value of the C++ type that `type` names.
template <class Work>
auto withType(ScalarType type, Work&& work) {
    switch (type) {
        case ScalarType::int8:
            return work(std::int8_t{});
        case ScalarType::uint8:
            return work(std::uint8_t{});
        case ScalarType::int16:
            return work(std::int16_t{});
        case ScalarType::uint16:
            return work(std::uint16_t{});
        case ScalarType::int32:
            return work(std::int32_t{});
        case ScalarType::uint32:
            return work(std::uint32_t{});
        case ScalarType::int64:
            return work(std::int64_t{});
        case ScalarType::uint64:
            return work(std::uint64_t{});
        case ScalarType::float32:
            return work(float{});
        case ScalarType::float64:
            break;
    }
    return work(double{});
}

/// The value as `Number`; out of range becomes the nearest limit, what is no number becomes 0.
template <class Number>
Number saturated(double value) {
    if constexpr (std::is_floating_point_v<Number>) {
        return static_cast<Number>(value);
    } else {
        if (std::isnan(value)) return 0;
        // The double of a 64-bit maximum is one above it, so the limits themselves are compared, not cast.
        if (value <= static_cast<double>(std::numeric_limits<Number>::min()))
            return std::numeric_limits<Number>::min();
        if (value >= static_cast<double>(std::numeric_limits<Number>::max()))
            return std::numeric_limits<Number>::max();
        return static_cast<Number>(std::nearbyint(value));
    }
}

}  // namespace

std::size_t sizeOf(ScalarType type) {
    return withType(type, [](auto zero) { return sizeof(zero); });
}

bool isInteger(ScalarType type) {
    return type != ScalarType::float32 && type != ScalarType::float64;
}

double readScalar(ScalarType type, const std::byte* at, std::endian order) {
    return withType(type, [&](auto zero) { return static_cast<double>(load<decltype(zero)>(at, order)); });
}

void writeScalar(ScalarType type, double value, std::byte* at) {
    withType(type, [&](auto zero) { store(at, saturated<decltype(zero)>(value)); });
}

}  // namespace vestige
