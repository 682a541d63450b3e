#pragma once

#include <string>
#include <vector>

#include "core/evaluation/SequenceEvaluation.h"

namespace vestige {

/// A row per score: method,voxel_m,filter,pairs,failed,rpe_m,rpe_deg,seconds,preprocess_seconds,delta,
/// rpe_median_m,rpe_max_m,rpe_median_deg,rpe_max_deg; an empty voxel was chosen automatically.
std::string sequenceCsv(const std::vector<SequenceScore>& scores);

/// A row per score and pair of neighbours: method,voxel_m,filter,target,source,moved_m,moved_deg,error_m,
/// error_deg,verdict,overlap,seconds; target and source are places in the sequence, from 0.
std::string pairsCsv(const std::vector<SequenceScore>& scores);

}  // namespace vestige
