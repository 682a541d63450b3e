#include "core/base/CleanText.h"

namespace vestige {
namespace {

/// The bytes of the UTF-8 character that `text` begins with; 0 where there is none. Overlong forms,
/// surrogates and what lies beyond Unicode are none (RFC 3629, section 4).
std::size_t characterLength(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : static_cast<unsigned char>(0);
    };
    const unsigned char first = byte(0);
    if (first < 0x80) return 1;
    if (first < 0xc2 || first > 0xf4) return 0;
    const std::size_t length = first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    const unsigned char second = byte(1);
    const bool outside = (first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
                         (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f);
    return outside ? 0 : length;
}

/// C0, DEL and C1.
bool isControl(std::string_view character) {
    const auto first = static_cast<unsigned char>(character[0]);
    return first < ' ' || first == 0x7f || (first == 0xc2 && static_cast<unsigned char>(character[1]) < 0xa0);
}

}  // namespace

std::string cleanText(std::string_view text, std::size_t longest) {
    std::string clean;
    while (!text.empty()) {
        const std::size_t length = characterLength(text);
        const std::string_view character = text.substr(0, length == 0 ? 1 : length);
        if (clean.size() + character.size() > longest) return clean + "...";
        if (length == 0 || isControl(character))
            clean += '?';
        else
            clean += character;
        text.remove_prefix(character.size());
    }
    return clean;
}

}  // namespace vestige
