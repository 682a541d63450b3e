#pragma once

#include <filesystem>
#include <string_view>

#include "core/io/ReadJob.h"

namespace vestige {

/// The file that a relative URI inside an index means: percent-decoded, query and fragment cut off, '\' taken
/// as '/', relative to `folder`. `root` and `folder` are canonical. Refuses addresses of a network, absolute
/// paths, and, symbolic links resolved, everything outside `root`; then what is missing or no file.
std::filesystem::path resolveTileUri(std::string_view uri, const std::filesystem::path& folder,
                                     const std::filesystem::path& root, const ReadJob& job);

}  // namespace vestige
