#pragma once

#include <optional>
#include <vector>

#include "ui/charts/ReChart.h"

namespace vestige {

/// The iterations of a registration as curves.
struct FitChart {
    struct Point {
        double score = 0;
        double voxel_m = 0;
        double trustRadius_m = 0;
        double step_m = 0;  ///< 0: none was tried
        bool taken = true;
    };
    std::vector<Point> points;        ///< one per iteration
    std::vector<std::size_t> levels;  ///< index of the first point of each voxel size
    std::optional<std::size_t> cursor;
};

/// Above, the score, each voxel size between the values it has there, since scores of different sizes do not
/// compare; below, voxel size, trust radius and step in metres on a logarithmic scale. Steps that were not
/// taken are hollow. Nothing is painted outside `area`.
void paintFitChart(QPainter& painter, const QRectF& area, const FitChart& chart, const ChartStyle& style);

/// The iteration under a position of the painted chart.
std::optional<std::size_t> iterationAt(const QRectF& area, const FitChart& chart, const ChartStyle& style,
                                       const QPointF& position);

}  // namespace vestige
