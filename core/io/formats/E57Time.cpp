#include "core/io/formats/E57Time.h"

#include <chrono>
#include <cmath>

namespace vestige {
namespace {

using namespace std::chrono;

constexpr double kWeek = 604800;
constexpr double kDay = 86400;
constexpr double kLatest = 1e10;  // some 300 years
constexpr sys_days kEpoch{year{1980} / January / 6};

sys_days firstOf(year_month_day date) {
    return sys_days{date.year() / January / 1};
}

}  // namespace

bool e57TimeIsAdjustedStandard(double start) {
    return start > kWeek && start < kLatest;
}

double e57TimeOffset(double start) {
    return e57TimeIsAdjustedStandard(start) ? start - kAdjustedStandard : start;
}

std::optional<std::pair<int, int>> dayYearOfGps(double seconds) {
    if (!(seconds > 0 && seconds < kLatest)) return std::nullopt;
    const sys_days date = kEpoch + days{static_cast<int>(std::floor(seconds / kDay))};
    const year_month_day parts{date};
    return std::pair{static_cast<int>((date - firstOf(parts)).count()) + 1, static_cast<int>(parts.year())};
}

double gpsOfDayYear(int day, int year) {
    const sys_days date = sys_days{std::chrono::year{year} / January / 1} + days{day - 1};
    return kDay * static_cast<double>((date - kEpoch).count());
}

}  // namespace vestige
