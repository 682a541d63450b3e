#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace vestige::test {

/// Little-endian bytes of the numbers, one after the other.
template <class Number>
std::string bytesOf(const std::vector<Number>& numbers) {
    std::string bytes(numbers.size() * sizeof(Number), '\0');
    std::memcpy(bytes.data(), numbers.data(), bytes.size());
    return bytes;
}

/// A data address of the bytes, in base64 as RFC 4648 has it.
inline std::string dataAddress(const std::string& bytes) {
    constexpr const char* kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text = "data:application/octet-stream;base64,";
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        std::string three = bytes.substr(at, 3);
        const std::size_t have = three.size();
        three.resize(3, '\0');
        const auto byte = [&](std::size_t i) {
            return static_cast<std::uint32_t>(static_cast<unsigned char>(three[i]));
        };
        const std::uint32_t bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for (std::size_t i = 0; i < 4; ++i) text += i > have ? '=' : kLetters[bits >> (18 - 6 * i) & 63];
    }
    return text;
}

/// A glTF document with one buffer; `rest` are the members behind "asset" and "buffers".
inline std::string gltfText(const std::string& buffer, const std::string& rest) {
    return R"({"asset":{"version":"2.0"},"buffers":[{"uri":")" + dataAddress(buffer) + R"(","byteLength":)" +
           std::to_string(buffer.size()) + "}]," + rest + "}";
}

}  // namespace vestige::test
