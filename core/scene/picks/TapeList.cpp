#include "core/scene/picks/TapeList.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "core/base/CleanText.h"
#include "core/base/Numbers.h"
#include "core/scene/picks/DelimitedText.h"

namespace vestige {
namespace {

/// Longer than anything that is taped at a scene.
constexpr double kLongest_m = 1e5;
constexpr const char* kExpected = "expected a header with object and tape_m, or rows of object and metres";

struct Columns {
    std::optional<std::size_t> object, tape, resolution, kind;
};

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(c == ' ' ? '_' : std::tolower(c)); });
    return text;
}

Columns columnsOf(const std::vector<std::string>& header) {
    Columns columns;
    for (std::size_t i = 0; i < header.size(); ++i) {
        const std::string name = lower(header[i]);
        if (name == "object") columns.object = i;
        if (name == "tape_m" || name == "tape") columns.tape = i;
        if (name == "tape_resolution_m") columns.resolution = i;
        if (name == "kind") columns.kind = i;
    }
    return columns;
}

Result<std::optional<double>> lengthIn(const DelimitedRow& row, std::optional<std::size_t> column,
                                       const char* name, const std::string& line) {
    if (!column || *column >= row.cells.size() || row.cells[*column].empty()) return std::nullopt;
    const std::string& cell = row.cells[*column];
    const auto value = parseReal(cell);
    // Also catches what is no number.
    if (!value || !(*value > 0 && *value <= kLongest_m))
        return fail(ErrorCode::input, std::string(name) + " is no length: '" + cleanText(cell) + "'", line,
                    "expected metres above 0 with '.', or nothing");
    return value;
}

Result<TapeRow> rowOf(const DelimitedRow& row, const Columns& columns, const std::string& place) {
    const std::string line = place + " line " + std::to_string(row.line);
    TapeRow read;
    read.line = row.line;
    if (*columns.object < row.cells.size()) read.object = row.cells[*columns.object];
    if (read.object.empty()) return fail(ErrorCode::input, "the object has no name", line);
    const auto tape = lengthIn(row, columns.tape, "the tape value", line);
    if (!tape) return fail(tape.error());
    const auto resolution = lengthIn(row, columns.resolution, "the tape's resolution", line);
    if (!resolution) return fail(resolution.error());
    read.tape_m = *tape;
    read.resolution_m = *resolution;
    if (columns.kind && *columns.kind < row.cells.size() && !row.cells[*columns.kind].empty()) {
        read.kind = measurementKindFromName(row.cells[*columns.kind]);
        if (!read.kind)
            return fail(ErrorCode::input,
                        "'" + cleanText(row.cells[*columns.kind]) + "' is no kind of measurement", line);
    }
    return read;
}

Result<std::vector<TapeRow>> rowsOf(const Result<DelimitedText>& table, const std::string& place) {
    if (!table) return fail(table.error());
    if (table->rows.empty()) return fail(ErrorCode::input, "there are no rows", place, kExpected);
    Columns columns = columnsOf(table->rows.front().cells);
    std::size_t first = 1;
    if (!columns.object) {
        const auto& cells = table->rows.front().cells;
        const bool plain = cells.size() == 2 && (cells[1].empty() || parseReal(cells[1]));
        if (!plain) {
            std::string second = cells.size() == 2 ? cells[1] : std::string();
            std::replace(second.begin(), second.end(), ',', '.');
            if (parseReal(second))
                return fail(ErrorCode::input, "'" + cleanText(cells[1]) + "' has a decimal comma",
                            place + " line 1", "expected a decimal number with '.'");
            return fail(ErrorCode::input, "no column is called object", place + " line 1", kExpected);
        }
        columns.object = 0;
        columns.tape = 1;
        first = 0;
    }
    std::vector<TapeRow> rows;
    std::map<std::string, std::size_t> placeOf;
    for (std::size_t i = first; i < table->rows.size(); ++i) {
        auto row = rowOf(table->rows[i], columns, place);
        if (!row) return fail(row.error());
        const auto [known, isNew] = placeOf.emplace(row->object, rows.size());
        if (isNew) {
            rows.push_back(std::move(*row));
        } else if (rows[known->second].tape_m != row->tape_m) {
            return fail(ErrorCode::input, "'" + cleanText(row->object) + "' has another tape value here",
                        place + " line " + std::to_string(row->line),
                        "expected that of line " + std::to_string(rows[known->second].line));
        }
    }
    if (rows.empty()) return fail(ErrorCode::input, "there are no rows below the header", place, kExpected);
    return rows;
}

}  // namespace

Result<std::vector<TapeRow>> parseTapeList(std::string_view text, const std::string& place) {
    return rowsOf(parseDelimited(text, place), place);
}

Result<std::vector<TapeRow>> readTapeList(const std::filesystem::path& file) {
    return rowsOf(readDelimited(file), file.string());
}

std::vector<Measurement> importTapes(const SceneState& scene, const std::vector<TapeRow>& rows) {
    std::vector<Measurement> changed;
    for (const TapeRow& row : rows) {
        const Measurement* known = scene.measurement(row.object);
        Measurement wanted = known ? *known : Measurement();
        wanted.object = row.object;
        if (row.tape_m) wanted.tape_m = row.tape_m;
        if (row.resolution_m) wanted.tapeResolution_m = row.resolution_m;
        // Picks belong to the kind that they were made for.
        if (row.kind && !known) wanted.kind = *row.kind;
        if (!known || !(wanted == *known)) changed.push_back(std::move(wanted));
    }
    return changed;
}

}  // namespace vestige
