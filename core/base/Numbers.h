#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace vestige {

/// Text <-> number, always with '.', whatever the locale.

/// The shortest decimal text that reads back as exactly this value; "nan", "inf", "-inf" for those.
std::string exactText(double value);
std::string exactText(float value);
/// `value` with `decimals` digits after the point, halves to even of the exact value.
std::string fixedText(double value, int decimals);

/// The whole of `text` (no blanks round it) as a number; nothing otherwise. Accepts a leading '+'.
std::optional<double> parseReal(std::string_view text);
std::optional<std::int64_t> parseInteger(std::string_view text);

/// The nearest float; the largest one for numbers beyond it, for which a conversion is undefined. What is
/// infinite or no number stays so.
float toFloat(double value);

}  // namespace vestige
