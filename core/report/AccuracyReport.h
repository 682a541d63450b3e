#pragma once

#include <string>
#include <vector>

#include "core/measurement/Accuracy.h"
#include "core/report/Section.h"

namespace vestige {

/// What there is to say about the accuracy of one or several methods: how it is computed, the RMSE with and
/// without exclusion, the excluded objects by name, every object, the bar chart.
std::vector<Block> accuracyBlocks(const std::vector<MethodAccuracy>& methods);

/// A report of nothing else, for a table of measured lengths. `date`: ISO 8601.
Report accuracyReport(const std::vector<MethodAccuracy>& methods, const std::string& tableName,
                      const std::string& date);

}  // namespace vestige
