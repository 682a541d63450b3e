#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/base/Result.h"

namespace vestige {

/// What the file system says of a file's content without reading it. Equal stamps: nobody has written to the
/// file or put another in its place (as far as its clock can tell).
struct FileStamp {
    std::uint64_t bytes = 0;
    std::int64_t modified_ns = 0;  ///< since 1970, UTC
    std::uint64_t device = 0;
    std::uint64_t inode = 0;

    friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

/// ErrorCode::input when there is no such file.
Result<FileStamp> stampOf(const std::filesystem::path& file);

/// Error to tell when a file has not kept its stamp while it was read: ErrorCode::input.
Error changedWhileRead(const std::filesystem::path& file, const FileStamp& before);

}  // namespace vestige
