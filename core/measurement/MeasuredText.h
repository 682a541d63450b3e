#pragma once

#include <optional>
#include <string>

namespace vestige {

/// How a measured length is told to people: in the report, on labels, in the window. Files for machines (CSV,
/// JSON) keep every digit.
///
/// GUM 7.2.6: the expanded uncertainty with two significant digits, the length rounded to the same decimal
/// place. Never finer than 0.1 mm, which no scanner resolves: there the uncertainty is rounded up, so that it
/// is not understated. Without an uncertainty millimetres.

struct MeasuredText {
    std::string value;        ///< "4.786", metres
    std::string uncertainty;  ///< "0.014", metres; empty without one
};
MeasuredText measuredText(double metres, std::optional<double> expandedUncertainty_m);

/// Decimal places of both: 0.0141 -> 3, 0.25 -> 2, 0.0996 -> 2, 0.00034 -> 4; 3 without an uncertainty.
int measuredDecimals(std::optional<double> expandedUncertainty_m);

/// "4.786 m ± 0.014 m"; "4.786 m" without an uncertainty.
std::string measuredSentence(double metres, std::optional<double> expandedUncertainty_m);

}  // namespace vestige
