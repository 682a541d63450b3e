#include "core/scene/picks/DelimitedText.h"

#include "core/base/AtomicFile.h"

namespace vestige {
namespace {

bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    return text;
}

char separatorOf(std::string_view line) {
    for (const char candidate : {'\t', ';', ','})
        if (line.find(candidate) != std::string_view::npos) return candidate;
    return ' ';
}

/// A quoted cell that begins at `at`; leaves `at` behind its closing quote. False where that is missing.
bool takeQuoted(std::string_view line, std::size_t& at, std::string& cell) {
    for (++at; at < line.size(); ++at) {
        if (line[at] != '"') {
            cell += line[at];
        } else if (at + 1 < line.size() && line[at + 1] == '"') {
            cell += line[at++];
        } else {
            ++at;
            return true;
        }
    }
    return false;
}

bool splitLine(std::string_view line, char separator, std::vector<std::string>& cells) {
    const auto parts = [separator](char c) { return separator == ' ' ? isBlank(c) : c == separator; };
    std::size_t at = 0;
    while (true) {
        while (at < line.size() && isBlank(line[at]) && !(separator == '\t' && line[at] == '\t')) ++at;
        std::string cell;
        if (at < line.size() && line[at] == '"') {
            if (!takeQuoted(line, at, cell)) return false;
        }
        // What follows a quoted cell belongs to it: people write 5" for inches.
        std::size_t end = at;
        while (end < line.size() && !parts(line[end])) ++end;
        cell += trimmed(line.substr(at, end - at));
        cells.push_back(std::move(cell));
        if (end >= line.size()) return true;
        at = end + 1;
        if (separator == ' ' && trimmed(line.substr(at)).empty()) return true;
    }
}

}  // namespace

Result<DelimitedText> parseDelimited(std::string_view text, const std::string& place) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    DelimitedText parsed;
    std::size_t number = 0;
    while (!text.empty()) {
        ++number;
        const std::size_t end = text.find('\n');
        const std::string_view line = trimmed(text.substr(0, end));
        const std::string_view whole = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (line.empty()) continue;
        if (parsed.rows.empty()) parsed.separator = separatorOf(line);
        DelimitedRow row{number, {}};
        // With tabs a first cell may be empty.
        const std::string_view cells = parsed.separator == '\t' ? whole : line;
        if (!splitLine(cells, parsed.separator, row.cells))
            return fail(ErrorCode::input, "a quoted cell is not closed",
                        place + " line " + std::to_string(number), "expected \" at its end");
        parsed.rows.push_back(std::move(row));
    }
    return parsed;
}

Result<DelimitedText> readDelimited(const std::filesystem::path& file) {
    // A cell takes 32 bytes and more, so a larger table could fill the memory.
    constexpr std::size_t kLargestTable = std::size_t{64} << 20;
    auto text = readTextFile(file, kLargestTable);
    if (!text) return fail(text.error());
    return parseDelimited(*text, file.string());
}

}  // namespace vestige
