#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/base/Result.h"
#include "core/geometry/Pose.h"

namespace vestige {

/// Known poses of a sequence, worldFromScanner, in the order of the file.
struct Trajectory {
    std::vector<Pose> poses;
    std::vector<std::int64_t> ids;  ///< ASL's poseId, the number of the scan; empty where there is none
};

/// ASL's pose CSV (header with poseId and T00 to T33, a 4x4 matrix a row) or lines `t x y z qx qy qz qw`,
/// blanks or commas between, `#` before a remark. ErrorCode::input names file and line.
Result<Trajectory> readTrajectory(const std::filesystem::path& file);

}  // namespace vestige
