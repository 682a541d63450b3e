#pragma once

#include <QRectF>

#include "core/report/Section.h"
#include "ui/charts/ReChart.h"

class QPainter;

namespace vestige {

/// Lines with a mark at every value on two logarithmic axes, legend above; dashed series are thinner.
/// Values that are not positive are left out. Nothing is painted outside `area`, and nothing at all without a
/// positive value.
void paintLineChart(QPainter& painter, const QRectF& area, const LineChart& chart, const ChartStyle& style);

}  // namespace vestige
