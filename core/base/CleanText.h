#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace vestige {

/// Foreign bytes for a sentence, a terminal or JSON: what is no UTF-8 (RFC 3629) and every control character
/// becomes '?'; a text longer than `longest` bytes is cut between characters and ends with "...".
std::string cleanText(std::string_view text, std::size_t longest = 60);

}  // namespace vestige
