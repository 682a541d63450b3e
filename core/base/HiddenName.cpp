#include "core/base/HiddenName.h"

#include <array>
#include <charconv>
#include <cstdint>

namespace vestige {
namespace {

constexpr std::size_t kLongestName = 255;
constexpr std::size_t kRoom = 64;
constexpr std::size_t kLongestExtension = 32;

/// FNV-1a with 64 bits, in hexadecimal digits.
std::string hashText(const std::string& text) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    std::array<char, 16> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), hash, 16).ptr;
    return {digits.data(), end};
}

}  // namespace

HiddenName hiddenNameOf(const std::filesystem::path& place) {
    HiddenName name{"." + place.stem().string(), place.extension().string()};
    if (name.extension.size() > kLongestExtension) name = {"." + place.filename().string(), {}};
    const std::size_t most = kLongestName - kRoom - name.extension.size();
    if (name.stem.size() <= most) return name;
    const std::string hash = "-" + hashText(place.filename().string());
    std::size_t kept = most - hash.size();
    // UTF-8: bytes 10xxxxxx go on with a character.
    while (kept > 1 && (static_cast<unsigned char>(name.stem[kept]) & 0xc0) == 0x80) --kept;
    name.stem = name.stem.substr(0, kept) + hash;
    return name;
}

}  // namespace vestige
