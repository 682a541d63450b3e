#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/Result.h"

namespace vestige {

/// A point of a list of picked points, in the unit and frame of whoever wrote it.
struct ListedPoint {
    std::size_t line = 0;                ///< of the file, from 1
    std::string label;                   ///< what stands before the coordinates; empty where nothing does
    std::optional<std::uint64_t> index;  ///< the label, where it is a whole number
    Eigen::Vector3d position;
};

/// The layouts that CloudCompare's picking writes: x,y,z; local index,x,y,z; global index,x,y,z; label
/// name,x,y,z; with and without a header line, parted as in DelimitedText. Errors: ErrorCode::input for no
/// points, another number of cells, a coordinate that is no number up to 1e10, with `place` and line.
Result<std::vector<ListedPoint>> parsePointList(std::string_view text, const std::string& place);
/// The same of a file.
Result<std::vector<ListedPoint>> readPointList(const std::filesystem::path& file);

}  // namespace vestige
