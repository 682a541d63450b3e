#include "core/base/Units.h"

namespace vestige {

double metresPer(LengthUnit unit) {
    return unit == LengthUnit::millimetre ? 0.001 : 1.0;
}

std::string_view symbol(LengthUnit unit) {
    return unit == LengthUnit::millimetre ? "mm" : "m";
}

std::optional<LengthUnit> lengthUnitFromSymbol(std::string_view symbol) {
    if (symbol == "m") return LengthUnit::metre;
    if (symbol == "mm") return LengthUnit::millimetre;
    return std::nullopt;
}

}  // namespace vestige
