#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/measurement/kinds/KindInput.h"

namespace vestige {
namespace {

/// The cloud's height at one place of the section.
struct Station {
    double along = 0;
    double height = 0;
    double standard = 0;  ///< of the height: 1.253 s / sqrt(n), of a median of normal values
    double degrees = 0;
};

Station stationOf(double along, std::vector<double>& heights) {
    const std::size_t n = heights.size(), half = n / 2;
    std::sort(heights.begin(), heights.end());
    const double median = n % 2 ? heights[half] : 0.5 * (heights[half - 1] + heights[half]);
    double mean = 0, squares = 0;
    for (const double height : heights) mean += height / static_cast<double>(n);
    for (const double height : heights) squares += (height - mean) * (height - mean);
    const double s = n > 1 ? std::sqrt(squares / static_cast<double>(n - 1)) : 0;
    return {along, median, std::sqrt(std::numbers::pi / 2) * s / std::sqrt(static_cast<double>(n)),
            static_cast<double>(n - 1)};
}

std::vector<Station> stationsOf(const KindInput& input, const Eigen::Vector2d& along, double length) {
    const auto count = static_cast<std::size_t>(input.settings.integer("samples"));
    const double halfWidth = input.settings.real("half_width_m");
    std::vector<std::vector<double>> heights(count);
    const Eigen::Vector2d from = input.at(0).head<2>();
    for (const Eigen::Vector3d& point : input.cloud) {
        const Eigen::Vector2d off = point.head<2>() - from;
        const double x = off.dot(along);
        if (!(x >= 0) || !(x < length)) continue;
        if (std::abs(along.x() * off.y() - along.y() * off.x()) > halfWidth) continue;
        const auto cell = static_cast<std::size_t>(x / length * static_cast<double>(count));
        heights[std::min(cell, count - 1)].push_back(point.z());
    }
    std::vector<Station> stations;
    for (std::size_t i = 0; i < count; ++i)
        if (!heights[i].empty())
            stations.push_back(
                stationOf(length * (static_cast<double>(i) + 0.5) / static_cast<double>(count), heights[i]));
    return stations;
}

QuantityValue heightAt(const char* key, const char* label, double value, const Station& station) {
    QuantityValue quantity{key, label, QuantityUnit::metre, value};
    if (station.degrees > 0)
        quantity.own.push_back(
            {"scatter of the cloud", station.standard, "m", 1, Distribution::student, station.degrees, 0});
    return quantity;
}

}  // namespace

Result<KindValues> profileValues(const KindInput& input) {
    const Eigen::Vector2d whole = (input.at(1) - input.at(0)).head<2>();
    const double length = whole.norm();
    if (!(length > 0)) return fail(ErrorCode::input, "the section has no length in plan");
    const std::vector<Station> stations = stationsOf(input, whole / length, length);
    KindValues values{{{"length", "Level length of the section", QuantityUnit::metre, length}}};
    if (stations.size() < 2) return values;
    const Station& first = stations.front();
    const Station& last = stations.back();
    const double run = last.along - first.along;
    const double rise = last.height - first.height;
    const Station* highest = &first;
    const Station* deepest = &first;
    double up = 0, down = 0, surface = 0;
    KindSeries line{"cloud", {}};
    for (std::size_t i = 0; i < stations.size(); ++i) {
        const Station& each = stations[i];
        const double over = each.height - (first.height + rise * (each.along - first.along) / run);
        if (over > up) up = over, highest = &each;
        if (over < down) down = over, deepest = &each;
        if (i > 0)
            surface += std::hypot(each.along - stations[i - 1].along, each.height - stations[i - 1].height);
        line.points.emplace_back(each.along, each.height);
    }
    values.quantities.push_back(heightAt("rise", "Height difference of its ends", rise, last));
    values.quantities.push_back({"grade", "Mean grade", QuantityUnit::percent, 100 * rise / run});
    values.quantities.push_back(heightAt("highest", "Highest above the line between its ends", up, *highest));
    values.quantities.push_back(
        heightAt("deepest", "Deepest below the line between its ends", -down, *deepest));
    values.quantities.push_back({"surface", "Length along the surface", QuantityUnit::metre, surface});
    const auto asked = static_cast<double>(input.settings.integer("samples"));
    values.quantities.push_back({"coverage", "Share of the section that has points", QuantityUnit::percent,
                                 100 * static_cast<double>(stations.size()) / asked});
    values.series = {std::move(line)};
    return values;
}

const ParameterTable& profileParameters() {
    static const ParameterTable table{
        {"half_width_m",
         "",
         "Half width of the section",
         "m",
         ParameterType::real,
         0.05,
         0.001,
         5.0,
         {},
         "Points within this distance of the line, in plan, belong to the section."},
        {"samples",
         "",
         "Places along the section",
         "",
         ParameterType::integer,
         std::int64_t{60},
         2.0,
         1000.0,
         {},
         "At how many places along the line the height is found, as the median of the points there."}};
    return table;
}

}  // namespace vestige
