#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vestige {

/// Puts the folder `ready` in the place of the folder `place` in one step, so that at every moment, whatever
/// is killed, the one or the other stands there whole; what stood there is then under the name `ready`.
/// False, and nothing done, where that cannot be, or would surprise: `place` holds other files than `known`
/// (names with '/'), is a link or a mount, belongs to somebody else, or a program works in it.
bool exchangeFolders(const std::filesystem::path& ready, const std::filesystem::path& place,
                     const std::vector<std::string>& known);

/// Gives the folder `ready` the name `place`, at which nothing stands; false when it cannot be.
bool renameFolder(const std::filesystem::path& ready, const std::filesystem::path& place);

}  // namespace vestige
