#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/evaluation/SequenceEvaluation.h"
#include "core/report/Section.h"

namespace vestige {

/// What a run is called beside others: "improved NDT", "improved NDT, gaussian".
std::string seriesName(const std::string& method, const std::string& filter);

/// Relative pose error, rotation and time by voxel, a line per method and filter; runs whose voxel was chosen
/// automatically stand in no chart. `table`: the rows of that published table
/// (PublishedTables.h) beside them, dashed.
std::vector<LineChart> sequenceCharts(std::span<const SequenceScore> scores, int table = 0);

}  // namespace vestige
