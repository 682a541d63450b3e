#pragma once

#include <filesystem>
#include <string>

namespace vestige {

/// What the names of hidden files beside a file begin and end with: `stem` is a dot and the file's own stem,
/// `extension` the file's. The stem of a long name is cut, at a whole character, and told apart by a hash of
/// the name, so that 64 bytes between the two fit into the 255 that a name may have; an extension of over 32
/// bytes counts as part of the stem. The same for the same name in every process.
struct HiddenName {
    std::string stem;
    std::string extension;
};
HiddenName hiddenNameOf(const std::filesystem::path& place);

}  // namespace vestige
