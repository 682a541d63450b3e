#include "core/report/QuantityText.h"

#include <algorithm>
#include <cmath>

#include "core/base/Numbers.h"
#include "core/measurement/MeasuredText.h"

namespace vestige {
namespace {

constexpr const char* kDash = "\u2013";

int decimalsOf(const QuantityStatistic& quantity) {
    const auto& u = quantity.expandedUncertainty;
    if (u && *u > 0 && std::isfinite(*u)) return measuredDecimals(u);
    return quantity.unit == QuantityUnit::metre ? 3 : 2;
}

std::string withUnit(const std::string& value, QuantityUnit unit) {
    return value + (unit == QuantityUnit::degree ? "" : " ") + std::string(readableSymbol(unit));
}

}  // namespace

bool isSkewed(const QuantityStatistic& quantity) {
    if (!quantity.low || !quantity.high || !quantity.expandedUncertainty) return false;
    const double below = quantity.mean - *quantity.low, above = *quantity.high - quantity.mean;
    return std::abs(above - below) > 0.05 * *quantity.expandedUncertainty;
}

std::string quantityValueText(const QuantityStatistic& quantity) {
    return fixedText(quantity.mean, decimalsOf(quantity));
}

std::string quantityUncertaintyText(const QuantityStatistic& quantity) {
    if (!quantity.expandedUncertainty) return kDash;
    const std::string text = measuredText(0, quantity.expandedUncertainty).uncertainty;
    return text.empty() ? "0" : text;
}

std::string quantityIntervalText(const QuantityStatistic& quantity) {
    if (!quantity.low || !quantity.high) return kDash;
    const int decimals = decimalsOf(quantity);
    const std::string low = fixedText(*quantity.low, decimals);
    return std::isfinite(*quantity.high) ? low + " to " + fixedText(*quantity.high, decimals)
                                         : low + " or more";
}

std::string quantitySentence(const QuantityStatistic& quantity) {
    const std::string value = withUnit(quantityValueText(quantity), quantity.unit);
    if (!quantity.expandedUncertainty) return value;
    if (isSkewed(quantity))
        return value + " (" + withUnit(quantityIntervalText(quantity), quantity.unit) + ")";
    return value + " \u00b1 " + withUnit(quantityUncertaintyText(quantity), quantity.unit);
}

}  // namespace vestige
