#include "core/report/SequenceCharts.h"

#include <algorithm>

#include "core/base/Units.h"
#include "core/report/PublishedTables.h"

namespace vestige {
namespace {

std::string methodName(const std::string& method) {
    if (method == "improved-ndt") return "improved NDT";
    if (method == "ndt") return "classic NDT";
    if (method == "icp") return "ICP";
    return method;
}

void add(LineChart& chart, const std::string& name, bool dashed, double x, double y) {
    auto found = std::find_if(chart.series.begin(), chart.series.end(),
                              [&](const auto& series) { return series.name == name; });
    if (found == chart.series.end()) {
        chart.series.push_back({name, {}, dashed});
        found = chart.series.end() - 1;
    }
    found->points.emplace_back(x, y);
}

}  // namespace

std::string seriesName(const std::string& method, const std::string& filter) {
    return filter == "none" ? methodName(method) : methodName(method) + ", " + filter;
}

std::vector<LineChart> sequenceCharts(std::span<const SequenceScore> scores, int table) {
    LineChart shift{"Relative pose error (RMS) by voxel", "Voxel (m)", "RPE (m)", {}};
    LineChart turn{"Rotation part of the relative pose error (RMS) by voxel", "Voxel (m)", "RPE (°)", {}};
    LineChart time{"Time of registration, all pairs, by voxel", "Voxel (m)", "Time (s)", {}};
    for (const SequenceScore& score : scores) {
        if (!score.voxel_m) continue;
        const std::string name = seriesName(score.method, score.filter);
        add(shift, name, false, *score.voxel_m, score.error.translation_m);
        add(turn, name, false, *score.voxel_m, degrees(score.error.rotation_rad));
        add(time, name, false, *score.voxel_m, score.seconds);
    }
    for (const PublishedRow& row : publishedTable(table)) {
        const std::string name = seriesName(std::string(row.method), std::string(row.filter)) + ", published";
        add(shift, name, true, row.voxel_m, row.rpe_m);
        add(time, name, true, row.voxel_m, row.seconds);
    }
    std::vector<LineChart> charts;
    for (LineChart* chart : {&shift, &turn, &time})
        if (!chart->series.empty()) charts.push_back(std::move(*chart));
    return charts;
}

}  // namespace vestige
