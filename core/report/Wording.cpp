#include "core/report/Wording.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <regex>

#include "core/base/Numbers.h"

namespace vestige {
namespace {

constexpr const char* kMinus = "\u2212";
constexpr const char* kNoBreakSpace = "\u00a0";

bool roundsToZero(double value, int decimals) {
    return std::abs(value) < 0.5 * std::pow(10.0, -decimals);
}

}  // namespace

std::string signedPercent(double fraction, int decimals) {
    const double value = 100 * fraction;
    if (roundsToZero(value, decimals)) return fixedText(0, decimals);
    return (value < 0 ? kMinus : "+") + fixedText(std::abs(value), decimals);
}

std::string percent(double fraction, int decimals) {
    return fixedText(100 * fraction, decimals) + kNoBreakSpace + "%";
}

std::string grouped(std::uint64_t count) {
    const std::string digits = std::to_string(count);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) text += kNoBreakSpace;
        text += digits[i];
    }
    return text;
}

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 == names.size() ? " and " : ", ";
        text += names[i];
    }
    return text;
}

std::string howMany(std::size_t count, const std::string& noun) {
    return grouped(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string orDash(const std::optional<std::string>& text) {
    return text.value_or("\u2013");
}

std::string duration(double seconds) {
    if (seconds < 59.95) return fixedText(seconds, 1) + " s";
    const auto whole = static_cast<std::int64_t>(std::lround(seconds));
    const std::string rest = std::to_string(whole % 60);
    return std::to_string(whole / 60) + " min " + (rest.size() < 2 ? "0" : "") + rest + " s";
}

std::string readableDate(const std::string& iso) {
    constexpr std::array kMonths{"January", "February", "March",     "April",   "May",      "June",
                                 "July",    "August",   "September", "October", "November", "December"};
    static const std::regex form(R"((\d{4})-(\d{2})-(\d{2})(?:T(\d{2}:\d{2})(?::\d{2}(?:\.\d+)?)?Z)?)");
    std::smatch part;
    if (!std::regex_match(iso, part, form)) return iso;
    const auto number = [&](std::size_t i) { return static_cast<std::size_t>(std::stoul(part[i].str())); };
    const std::size_t month = number(2);
    if (month < 1 || month > kMonths.size()) return iso;
    std::string text = std::to_string(number(3)) + " " + kMonths[month - 1] + " " + part[1].str();
    if (part[4].matched) text += ", " + part[4].str() + " UTC";
    return text;
}

std::string minutes(double seconds) {
    return fixedText(seconds / 60, 2);
}

}  // namespace vestige
