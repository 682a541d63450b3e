#pragma once

#include <optional>
#include <utility>

namespace vestige {

/// E57 counts GPS seconds from 1980-01-06 and time stamps from the scan's start; LAS has GPS seconds of the
/// week, or less 1e9 ("adjusted standard time").
inline constexpr double kAdjustedStandard = 1e9;

/// What to add to the time stamps of a scan that starts at `start`. Where that is a date, the sums are
/// adjusted standard time; where it is 0 or missing, the stamps stay what they are.
double e57TimeOffset(double start);
bool e57TimeIsAdjustedStandard(double start);

/// Day of the year (from 1) and year of GPS seconds, leap seconds left out; nothing where that is no date
/// after 1980.
std::optional<std::pair<int, int>> dayYearOfGps(double seconds);
double gpsOfDayYear(int day, int year);

}  // namespace vestige
