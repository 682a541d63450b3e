#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <string_view>

namespace vestige {

/// The unit of a file's coordinates. Inside Vestige lengths are metres and angles radians.
enum class LengthUnit { metre, millimetre };

double metresPer(LengthUnit unit);
std::string_view symbol(LengthUnit unit);
std::optional<LengthUnit> lengthUnitFromSymbol(std::string_view symbol);

constexpr double radians(double degrees) {
    return degrees * std::numbers::pi / 180.0;
}
constexpr double degrees(double radians) {
    return radians * 180.0 / std::numbers::pi;
}

}  // namespace vestige
