#pragma once

#include <QString>
#include <vector>

#include "ui/charts/ReChart.h"

namespace vestige {

/// Bars of equal width that lie evenly round zero.
struct Histogram {
    std::vector<std::size_t> counts;  ///< an odd number
    double width = 1;                 ///< of a bar, in the unit shown
    QString unit;
    std::size_t outside = 0;  ///< beyond the first and last bar
};

/// The bars over an axis with its unit, zero marked, and how many lie outside. Nothing is painted outside
/// `area`.
void paintHistogram(QPainter& painter, const QRectF& area, const Histogram& histogram,
                    const ChartStyle& style);

}  // namespace vestige
