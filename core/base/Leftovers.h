#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vestige {

/// What marks temporary files as this process's own: its number and a word for the machine (and container)
/// that counts it.
std::string ownerMark();

/// Whether the process that a mark names is gone for certain. Of other machines nothing is certain.
bool ownerIsGone(const std::string& mark);

/// Temporary files and folders in `folder` whose names are `prefix`, an owner's mark and `suffix`, and whose
/// owner was killed: gone for certain or, of other machines, not heard of for a day.
std::vector<std::filesystem::path> leftovers(const std::filesystem::path& folder, const std::string& prefix,
                                             const std::string& suffix);

}  // namespace vestige
