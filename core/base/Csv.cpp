#include "core/base/Csv.h"

#include "core/base/AtomicFile.h"

namespace vestige {

Result<std::vector<CsvRow>> parseCsv(std::string_view text, const std::string& place) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    std::vector<CsvRow> rows;
    std::size_t line = 1;
    std::size_t i = 0;
    while (i < text.size()) {
        CsvRow row{line, {}};
        bool endOfRow = false;
        while (!endOfRow) {
            std::string cell;
            if (i < text.size() && text[i] == '"') {
                for (++i;; ++i) {
                    if (i >= text.size())
                        return fail(ErrorCode::input, "a quoted cell is not closed",
                                    place + ":" + std::to_string(row.line));
                    if (text[i] == '\n') ++line;
                    if (text[i] != '"') {
                        cell += text[i];
                    } else if (i + 1 < text.size() && text[i + 1] == '"') {
                        cell += text[i++];
                    } else {
                        ++i;
                        break;
                    }
                }
                if (i < text.size() && text[i] != ',' && text[i] != '\r' && text[i] != '\n')
                    return fail(ErrorCode::input, "text follows a quoted cell",
                                place + ":" + std::to_string(line),
                                "expected a comma or the end of the line");
            } else {
                while (i < text.size() && text[i] != ',' && text[i] != '\n' && text[i] != '\r')
                    cell += text[i++];
            }
            row.cells.push_back(std::move(cell));
            if (i < text.size() && text[i] == ',') {
                ++i;
                continue;
            }
            if (i < text.size() && text[i] == '\r') ++i;
            if (i < text.size() && text[i] == '\n') ++i;
            ++line;
            endOfRow = true;
        }
        if (row.cells.size() > 1 || !row.cells.front().empty()) rows.push_back(std::move(row));
    }
    return rows;
}

Result<std::vector<CsvRow>> readCsv(const std::filesystem::path& file) {
    // Tables that people and Vestige write; a cell takes 32 bytes and more, so a larger one could fill the
    // memory.
    constexpr std::size_t kLargestTable = std::size_t{64} << 20;
    auto text = readTextFile(file, kLargestTable);
    if (!text) return fail(text.error());
    return parseCsv(*text, file.string());
}

std::string csvLine(const std::vector<std::string>& cells) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (i > 0) line += ',';
        if (cells[i].find_first_of(",\"\r\n") == std::string::npos) {
            line += cells[i];
            continue;
        }
        line += '"';
        for (const char c : cells[i]) {
            if (c == '"') line += '"';
            line += c;
        }
        line += '"';
    }
    return line + "\r\n";
}

}  // namespace vestige
