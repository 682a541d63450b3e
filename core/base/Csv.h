#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/Result.h"

namespace vestige {

/// RFC 4180 with '.' as decimal mark. One row per line of the file; `line` is where it begins (1-based).
struct CsvRow {
    std::size_t line = 0;
    std::vector<std::string> cells;
};
Result<std::vector<CsvRow>> parseCsv(std::string_view text, const std::string& place);
Result<std::vector<CsvRow>> readCsv(const std::filesystem::path& file);

/// One line with CR LF, cells quoted where they must be.
std::string csvLine(const std::vector<std::string>& cells);

}  // namespace vestige
