#pragma once

#include <cstring>
#include <initializer_list>
#include <string>
#include <vector>

namespace vestige::test {

/// The bytes of numbers, one after the other (the tests run on little endian machines).
template <class Number>
std::string bytesOf(const std::vector<Number>& numbers) {
    std::string bytes(numbers.size() * sizeof(Number), '\0');
    if (!numbers.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
    return bytes;
}
template <class Number>
std::string bytesOf(std::initializer_list<Number> numbers) {
    return bytesOf(std::vector<Number>(numbers));
}

/// A point tile of 3D Tiles 1.0, written by its specification.
std::string pntsBytes(std::string featureJson, std::string featureBinary, std::string batchJson = {},
                      std::string batchBinary = {});

}  // namespace vestige::test
