#pragma once

#include <filesystem>
#include <string>

namespace vestige::fuzz {

/// Puts into the folder the files that an input of this extension may name: tile.pnts and more.json for a
/// tileset (json), tile.s3mb for an index (scp), buffer.bin for a glTF document; nothing for others.
void putBeside(const std::string& extension, const std::filesystem::path& folder);

}  // namespace vestige::fuzz
