#include "core/base/Units.h"

#include <algorithm>
#include <cmath>

namespace vestige {
namespace {

struct UnitRow {
    LengthUnit unit;
    double metres;
    std::string_view symbol;
    std::string_view name;
};

constexpr std::array kRows{UnitRow{LengthUnit::metre, 1, "m", "metres"},
                           UnitRow{LengthUnit::centimetre, 0.01, "cm", "centimetres"},
                           UnitRow{LengthUnit::millimetre, 0.001, "mm", "millimetres"},
                           UnitRow{LengthUnit::micrometre, 1e-6, "um", "micrometres"},
                           UnitRow{LengthUnit::foot, 0.3048, "ft", "feet"},
                           UnitRow{LengthUnit::usSurveyFoot, 1200.0 / 3937.0, "ftUS", "US survey feet"},
                           UnitRow{LengthUnit::inch, 0.0254, "in", "inches"}};

const UnitRow& rowOf(LengthUnit unit) {
    return *std::find_if(kRows.begin(), kRows.end(), [&](const UnitRow& row) { return row.unit == unit; });
}

}  // namespace

double metresPer(LengthUnit unit) {
    return rowOf(unit).metres;
}

std::string_view symbol(LengthUnit unit) {
    return rowOf(unit).symbol;
}

std::string_view nameOf(LengthUnit unit) {
    return rowOf(unit).name;
}

std::optional<LengthUnit> lengthUnitFromSymbol(std::string_view symbol) {
    for (const UnitRow& row : kRows)
        if (row.symbol == symbol) return row.unit;
    return std::nullopt;
}

std::string lengthUnitSymbols() {
    std::string text;
    for (const LengthUnit unit : kLengthUnits) text += (text.empty() ? "" : ", ") + std::string(symbol(unit));
    return text;
}

std::optional<LengthUnit> lengthUnitOf(double metresPerUnit) {
    for (const UnitRow& row : kRows)
        if (std::abs(metresPerUnit / row.metres - 1) < 1e-7) return row.unit;
    return std::nullopt;
}

LengthUnit nearestLengthUnit(double metresPerUnit) {
    const auto distance = [&](const UnitRow& row) { return std::abs(std::log(metresPerUnit / row.metres)); };
    return std::min_element(kRows.begin(), kRows.end(),
                            [&](const UnitRow& a, const UnitRow& b) { return distance(a) < distance(b); })
        ->unit;
}

}  // namespace vestige
