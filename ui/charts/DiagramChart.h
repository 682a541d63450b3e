#pragma once

#include <QRectF>

#include "core/report/Section.h"
#include "ui/charts/ReChart.h"

class QPainter;

namespace vestige {

/// Lines on two even axes with round ticks, legend above where there is more than one; series with dots mark
/// their points. Nothing is painted outside `area`, and nothing at all without a point.
void paintDiagram(QPainter& painter, const QRectF& area, const Diagram& diagram, const ChartStyle& style);

}  // namespace vestige
