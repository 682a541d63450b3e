#pragma once

#include <filesystem>
#include <vector>

#include "core/base/Result.h"

namespace vestige {

/// The clouds of a sequence, in natural order of their names (2 before 10).
struct SequenceFiles {
    std::vector<std::filesystem::path> clouds;
    bool inWorldFrame = false;  ///< ASL's PointCloudN.csv: each in the frame of the known poses
};

/// The clouds of a folder: ASL's Hokuyo_N.csv where there are any, else PointCloudN.csv, else every file of a
/// readable format but `truth`. ErrorCode::input when there are fewer than two.
Result<SequenceFiles> sequenceFiles(const std::filesystem::path& folder, const std::filesystem::path& truth);

/// Whether a comes before b when runs of digits count as numbers.
bool naturallyBefore(const std::string& a, const std::string& b);

}  // namespace vestige
