#include "core/report/MeasurementsCsv.h"

#include <algorithm>
#include <array>

#include "core/base/Csv.h"
#include "core/base/Numbers.h"

namespace vestige {
namespace {

constexpr std::size_t kRule = 3;  // repeats that have their place in the middle of the row

std::string text(const std::optional<double>& value) {
    return value ? exactText(*value) : std::string();
}

std::string repeat(const MeasuredLength& length, std::size_t i) {
    return length.length && i < length.length->repeats_m.size() ? exactText(length.length->repeats_m[i])
                                                                : std::string();
}

const MeasuredKind* kindOf(const MeasuredScene& measured, const MeasuredLength& length) {
    for (const MeasuredKind& kind : measured.kinds)
        if (kind.object == length.object && kind.method == length.method) return &kind;
    return nullptr;
}

std::string meanOf(const MeasuredKind* kind, const std::string& quantity) {
    const QuantityStatistic* found = kind ? kind->find(quantity) : nullptr;
    return found ? exactText(found->mean) : std::string();
}

}  // namespace

std::string measurementsCsv(const MeasuredScene& measured) {
    std::size_t repeats = kRule;
    for (const auto& length : measured.lengths)
        if (length.length) repeats = std::max(repeats, length.length->repeats_m.size());

    std::vector<std::string> head{
        "object",       "method",          "tape_m",      "measured_1_m",           "measured_2_m",
        "measured_3_m", "measured_mean_m", "repeat_sd_m", "expanded_uncertainty_m", "re",
        "excluded"};
    for (std::size_t i = kRule; i < repeats; ++i) head.push_back("measured_" + std::to_string(i + 1) + "_m");
    for (const char* name : {"kind", "horizontal_m", "vertical_m"}) head.emplace_back(name);
    head.emplace_back("small");
    std::string csv = csvLine(head);
    for (const auto& length : measured.lengths) {
        const auto& statistic = length.length;
        std::vector<std::string> row{length.object, length.method, text(length.tape_m)};
        for (std::size_t i = 0; i < kRule; ++i) row.push_back(repeat(length, i));
        row.push_back(statistic ? exactText(statistic->mean_m) : std::string());
        row.push_back(statistic ? text(statistic->repeatSd_m) : std::string());
        row.push_back(statistic ? text(statistic->expandedUncertainty_m) : std::string());
        row.push_back(text(length.re));
        row.push_back(length.excluded ? "true" : "false");
        for (std::size_t i = kRule; i < repeats; ++i) row.push_back(repeat(length, i));
        const MeasuredKind* kind = kindOf(measured, length);
        row.push_back(kind ? std::string(name(kind->kind)) : std::string());
        row.push_back(meanOf(kind, "horizontal"));
        row.push_back(meanOf(kind, "vertical"));
        row.push_back(length.small ? "true" : "false");
        csv += csvLine(row);
    }
    return csv;
}

}  // namespace vestige
