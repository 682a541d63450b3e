#pragma once

#include <span>
#include <vector>

#include "core/measurement/Accuracy.h"
#include "core/report/Section.h"

namespace vestige {

/// Signed relative errors in percent, a group per object (in the order in which the methods first name
/// them), a series per method.
BarChart relativeErrorChart(std::span<const MethodAccuracy> methods);

/// The same in several charts of at most `mostObjects` objects each, so that the names stay readable.
std::vector<BarChart> relativeErrorCharts(std::span<const MethodAccuracy> methods,
                                          std::size_t mostObjects = 12);

}  // namespace vestige
