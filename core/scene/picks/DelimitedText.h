#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/Result.h"

namespace vestige {

/// A table as text, whatever parts its cells.
struct DelimitedRow {
    std::size_t line = 0;  ///< of the file, from 1
    std::vector<std::string> cells;
};
struct DelimitedText {
    char separator = ',';  ///< ' ': any run of blanks
    std::vector<DelimitedRow> rows;
};

/// Cells parted by tab, semicolon, comma or blanks: the first of these that the first line has. Cells may be
/// quoted as in RFC 4180, within their line; blanks round a cell do not count, empty lines neither. Errors:
/// ErrorCode::input for a quote that is not closed, with `place` and line.
Result<DelimitedText> parseDelimited(std::string_view text, const std::string& place);
/// The same of a file of at most 64 MB.
Result<DelimitedText> readDelimited(const std::filesystem::path& file);

}  // namespace vestige
