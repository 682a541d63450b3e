#pragma once

#include <filesystem>
#include <vector>

#include "core/base/Result.h"
#include "core/measurement/Accuracy.h"

namespace vestige {

/// A table of columns `object,tape_m,<name>_m,...` (RFC 4180; an empty cell is not measured), one
/// MethodAccuracy per column. ErrorCode::input names file, line and column.
Result<std::vector<MethodAccuracy>> readAccuracyTable(const std::filesystem::path& csv);

}  // namespace vestige
