#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vestige {

/// Numbers as a reader of the report sees them (exact figures are in the CSV and JSON files).

/// A fraction in percent, signed with a real minus: 0.0427 -> "+4.27 %" (without the unit: "+4.27").
std::string signedPercent(double fraction, int decimals = 2);
std::string percent(double fraction, int decimals = 1);
/// 10342112 -> "10 342 112", held together by no-break spaces.
std::string grouped(std::uint64_t count);
/// "a, b and c"
std::string listed(const std::vector<std::string>& names);
/// "1 object", "3 objects"
std::string howMany(std::size_t count, const std::string& noun);
/// A value that may be missing; "–" where it is.
std::string orDash(const std::optional<std::string>& text);
/// "2 min 05 s", "8.3 s"
std::string duration(double seconds);
/// "2026-11-22T08:07:57Z" -> "22 November 2026, 08:07 UTC"; "2026-11-22" -> "22 November 2026". What is not
/// such a date stays as it is.
std::string readableDate(const std::string& iso);
/// 125 -> "2.08"
std::string minutes(double seconds);

}  // namespace vestige
