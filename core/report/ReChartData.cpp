#include "core/report/ReChartData.h"

#include <algorithm>

namespace vestige {

BarChart relativeErrorChart(std::span<const MethodAccuracy> methods) {
    BarChart chart;
    chart.caption = "Relative error of each object by method, in percent of its tape value";
    chart.unit = "%";
    for (const auto& method : methods)
        for (const auto& object : method.objects)
            if (std::find(chart.categories.begin(), chart.categories.end(), object.object) ==
                chart.categories.end())
                chart.categories.push_back(object.object);
    for (const auto& method : methods) {
        BarChart::Series series{method.name, std::vector<std::optional<double>>(chart.categories.size()),
                                std::vector<bool>(chart.categories.size(), false)};
        for (const auto& object : method.objects) {
            const auto place = std::find(chart.categories.begin(), chart.categories.end(), object.object);
            const auto i = static_cast<std::size_t>(place - chart.categories.begin());
            if (object.re) series.values[i] = 100 * *object.re;
            series.excluded[i] = object.excluded;
        }
        chart.series.push_back(std::move(series));
    }
    return chart;
}

std::vector<BarChart> relativeErrorCharts(std::span<const MethodAccuracy> methods, std::size_t mostObjects) {
    const BarChart whole = relativeErrorChart(methods);
    const std::size_t objects = whole.categories.size();
    const std::size_t count = (objects + mostObjects - 1) / mostObjects;
    std::vector<BarChart> charts;
    for (std::size_t k = 0; k < count; ++k) {
        const auto from = static_cast<std::ptrdiff_t>(k * objects / count);
        const auto to = static_cast<std::ptrdiff_t>((k + 1) * objects / count);
        BarChart part{
            whole.caption, whole.unit, {whole.categories.begin() + from, whole.categories.begin() + to}, {}};
        if (count > 1)
            part.caption = part.caption + " (" + std::to_string(k + 1) + " of " + std::to_string(count) + ")";
        for (const auto& series : whole.series)
            part.series.push_back({series.name,
                                   {series.values.begin() + from, series.values.begin() + to},
                                   {series.excluded.begin() + from, series.excluded.begin() + to}});
        charts.push_back(std::move(part));
    }
    return charts;
}

}  // namespace vestige
