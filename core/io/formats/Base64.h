#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace vestige {

/// RFC 4648 with padding.
std::string base64Of(std::span<const std::byte> bytes);
/// Nothing where a character does not belong; padding may be missing.
std::optional<std::string> bytesOfBase64(std::string_view text);

}  // namespace vestige
