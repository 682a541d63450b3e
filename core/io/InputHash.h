#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/io/FileInfo.h"

namespace vestige {

/// What an input is made of, and its hashes.
struct InputHash {
    /// Of a single file its SHA-256. Where others belong to it (the tiles of a tileset, the buffers of a glTF
    /// scene) that of the list of all, as the program sha256sum prints it: a line "HASH  NAME" each, the file
    /// first, then the others in the order of their names relative to its folder.
    std::string sha256;
    std::vector<std::string> companions;  ///< SHA-256 of each companion, in the order given
};

/// `companions` is FileInfo::companions. ErrorCode::input when one cannot be read.
Result<InputHash> hashInput(const std::filesystem::path& file,
                            const std::vector<std::filesystem::path>& companions,
                            const JobControl& control = {});
/// The same where the file's own SHA-256 is known.
Result<InputHash> hashInput(const std::filesystem::path& file, const std::string& ownSha256,
                            const std::vector<std::filesystem::path>& companions,
                            const JobControl& control = {});

/// ErrorCode::input when a file that was read for this one has been written to or replaced since: what was
/// made of it and its hash may differ.
Status companionsAsRead(const FileInfo& info);

}  // namespace vestige
