#pragma once

#include <array>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

namespace vestige {

/// The unit of a file's coordinates. Inside Vestige lengths are metres and angles radians.
enum class LengthUnit { metre, centimetre, millimetre, micrometre, foot, usSurveyFoot, inch };

/// In the order in which they are offered.
inline constexpr std::array kLengthUnits{
    LengthUnit::metre, LengthUnit::millimetre,   LengthUnit::centimetre, LengthUnit::micrometre,
    LengthUnit::foot,  LengthUnit::usSurveyFoot, LengthUnit::inch};

/// Exact by definition: a foot is 0.3048 m, an inch 0.0254 m (1959), a US survey foot 1200/3937 m (1893).
double metresPer(LengthUnit unit);
/// "m", "cm", "mm", "um", "ft", "ftUS", "in"; what command line, case file and JSON call them.
std::string_view symbol(LengthUnit unit);
/// "metres", "US survey feet": for sentences.
std::string_view nameOf(LengthUnit unit);
std::optional<LengthUnit> lengthUnitFromSymbol(std::string_view symbol);
/// "m, mm, cm, um, ft, ftUS, in": for messages.
std::string lengthUnitSymbols();

/// The unit of that length, to one part in ten million, which tells the two feet apart.
std::optional<LengthUnit> lengthUnitOf(double metresPerUnit);
/// The unit whose length is nearest by ratio.
LengthUnit nearestLengthUnit(double metresPerUnit);

constexpr double radians(double degrees) {
    return degrees * std::numbers::pi / 180.0;
}
constexpr double degrees(double radians) {
    return radians * 180.0 / std::numbers::pi;
}

}  // namespace vestige
