#pragma once

#include <filesystem>
#include <vector>

#include "core/base/Result.h"
#include "core/geometry/Pose.h"

namespace vestige {

/// Known poses of a sequence, worldFromScanner, in the order of the file: ASL's pose CSV (header with T00 to
/// T33, a 4x4 matrix a row) or lines `t x y z qx qy qz qw`, blanks or commas between, `#` before a remark.
/// ErrorCode::input names file and line.
Result<std::vector<Pose>> readTrajectory(const std::filesystem::path& file);

}  // namespace vestige
