#pragma once

#include <cstdint>
#include <filesystem>
#include <system_error>

namespace vestige {

/// Files above this are not forced to the disk (docs/decisions/0016-case-store.md).
constexpr std::uintmax_t kLargestSyncedFile = std::uintmax_t{64} << 20;

/// Returns when the file's content is on the disk, so that it outlasts a power failure. Files above
/// kLargestSyncedFile are left to the system. An error is the disk's: full or broken.
std::error_code syncFile(const std::filesystem::path& file);
/// The same for the names in a folder. File systems that do not know this are content.
void syncFolder(const std::filesystem::path& folder);

}  // namespace vestige
