#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace vestige {

/// %XX as the byte XX (RFC 3986, 2.1); what is no such triple stays as it is.
std::string percentDecoded(std::string_view uri);

/// Whether the file lies within the folder or is it; both canonical.
bool isInside(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace vestige
