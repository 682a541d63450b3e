#pragma once

#include <vector>

#include "core/io/formats/LasHeader.h"

namespace vestige {

/// Refuses a compressed file whose LASzip record or chunk table does not fit its header or size.
void checkLaz(std::span<const std::byte> file, const LasHeader& header, const ReadJob& job);

/// What stands before the points, rewritten from checked values for LASzip: header, LASzip's record, nothing
/// else; as long as in the file, so that places inside the file stay true.
std::vector<std::byte> lazPrefix(std::span<const std::byte> file, const LasHeader& header);

}  // namespace vestige
