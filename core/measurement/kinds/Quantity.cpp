#include "core/measurement/kinds/Quantity.h"

namespace vestige {

std::string_view symbol(QuantityUnit unit) {
    switch (unit) {
        case QuantityUnit::metre:
            return "m";
        case QuantityUnit::degree:
            return "deg";
        case QuantityUnit::squareMetre:
            return "m2";
        case QuantityUnit::cubicMetre:
            return "m3";
        case QuantityUnit::percent:
            return "%";
        case QuantityUnit::kilometrePerHour:
            return "km/h";
    }
    return "m";
}

std::string_view readableSymbol(QuantityUnit unit) {
    switch (unit) {
        case QuantityUnit::degree:
            return "\u00b0";
        case QuantityUnit::squareMetre:
            return "m\u00b2";
        case QuantityUnit::cubicMetre:
            return "m\u00b3";
        default:
            return symbol(unit);
    }
}

}  // namespace vestige
