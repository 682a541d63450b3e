#pragma once

#include <QColor>
#include <QFont>
#include <QRectF>
#include <vector>

#include "core/report/Section.h"

class QPainter;
class QPalette;

namespace vestige {

/// How a chart looks; lengths in the painter's units.
struct ChartStyle {
    QFont font;  ///< size set in pixels
    double line = 1;
    QColor text;
    QColor muted;
    QColor grid;
    QColor background;
    std::vector<QColor> series;
    bool showCategories = true;
    bool showValues = true;
};

/// On the background of a panel with that palette, dark or light.
ChartStyle panelChartStyle(const QFont& font, const QPalette& palette);
/// Opaque colours on white.
ChartStyle paperChartStyle(const QFont& font, double line);

/// Grouped bars round a zero line, one group per category (the relative errors of each object by method, as
/// in the figures of the publication): filled bars count, hollow ones are excluded, a missing value is
/// marked "n/m". The bar of an excluded value that would flatten the others is cut, with a head at its end.
/// Nothing is painted outside `area`.
void paintReChart(QPainter& painter, const QRectF& area, const BarChart& chart, const ChartStyle& style);

}  // namespace vestige
