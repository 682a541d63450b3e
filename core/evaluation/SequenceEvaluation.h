#pragma once

#include <string>
#include <vector>

#include "core/base/JobControl.h"
#include "core/base/ParameterSet.h"
#include "core/base/Result.h"
#include "core/evaluation/RelativePoseError.h"
#include "core/geometry/PointCloud.h"

namespace vestige {

/// Clouds in their scanner's frames, metres, and the known poses worldFromScanner.
struct Sequence {
    std::vector<PointCloud> clouds;
    std::vector<Pose> truth;
};

/// Reads what sequenceFiles and readTrajectory find. ErrorCode::input when their numbers differ.
Result<Sequence> readSequence(const std::filesystem::path& folder, const std::filesystem::path& truth,
                              const JobControl& control = {});

/// One row of the comparison.
struct SequenceScore {
    std::string method;
    std::string voxel;  ///< as asked for: a length in m, or "auto"
    std::string filter;
    RelativePoseError error;
    std::size_t failed = 0;        ///< pairs without a trustworthy pose; they count as not moved
    double seconds = 0;            ///< registration, all pairs
    double preprocessSeconds = 0;  ///< all clouds
};

/// Registers each cloud to the one before, from identity, and compares the chain of poses with the truth.
Result<SequenceScore> evaluateSequence(const Sequence& sequence, const ParameterSet& preprocessing,
                                       const ParameterSet& registration, const JobControl& control = {});

/// method,voxel_m,filter,pairs,failed,rpe_m,rpe_deg,seconds,preprocess_seconds with a row per score.
std::string sequenceCsv(const std::vector<SequenceScore>& scores);

}  // namespace vestige
