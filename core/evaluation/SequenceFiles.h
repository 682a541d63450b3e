#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/base/Result.h"

namespace vestige {

/// The clouds of a sequence, in natural order of their names (2 before 10).
struct SequenceFiles {
    std::vector<std::filesystem::path> clouds;
    std::vector<std::int64_t> ids;  ///< N of each ASL cloud; empty for others
    bool inWorldFrame = false;      ///< ASL's PointCloudN.csv: each in the frame of the known poses
};

/// The clouds of a folder: ASL's Hokuyo_N.csv where there are any, else PointCloudN.csv, else, of the files
/// of a readable format but `truth`, those of the extension that most of them have (ties to the first in the
/// alphabet): a table beside the clouds is none. ErrorCode::input when there are fewer than two.
Result<SequenceFiles> sequenceFiles(const std::filesystem::path& folder, const std::filesystem::path& truth);

/// Whether a comes before b when runs of digits count as numbers.
bool naturallyBefore(const std::string& a, const std::string& b);

}  // namespace vestige
