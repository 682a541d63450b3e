#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/io/ReadJob.h"
#include "core/io/ScalarType.h"

namespace vestige {

struct PlyProperty {
    std::string name;
    ScalarType type = ScalarType::float32;
    bool list = false;
    ScalarType lengthType = ScalarType::uint8;  ///< of a list
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
    std::size_t line = 0;
};

enum class PlyEncoding { ascii, littleEndian, bigEndian };

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::ascii;
    std::vector<PlyElement> elements;
    std::size_t bodyOffset = 0;
    std::size_t bodyLine = 0;
};

/// Refuses what is no PLY header, at its line.
PlyHeader parsePlyHeader(std::string_view text, const ReadJob& job);

}  // namespace vestige
