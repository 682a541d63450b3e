#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/io/ReadJob.h"
#include "core/io/ScalarType.h"

namespace vestige {

struct PcdField {
    std::string name;
    ScalarType type = ScalarType::float32;
    std::size_t count = 1;
    std::size_t offset = 0;  ///< of its first byte in a point's record
    std::size_t column = 0;  ///< of its first value in a point's row
    std::size_t bytes() const { return sizeOf(type) * count; }
};

enum class PcdEncoding { ascii, binary, compressed };

struct PcdHeader {
    std::string version;
    std::vector<PcdField> fields;
    std::size_t points = 0;
    std::size_t stride = 0;   ///< bytes of a point
    std::size_t columns = 0;  ///< values of a point
    PcdEncoding encoding = PcdEncoding::ascii;
    bool movedViewpoint = false;
    std::size_t fieldsLine = 0;
    std::size_t bodyOffset = 0;
    std::size_t bodyLine = 0;
};

/// Refuses what is no PCD header, at its line.
PcdHeader parsePcdHeader(std::string_view text, const ReadJob& job);

}  // namespace vestige
