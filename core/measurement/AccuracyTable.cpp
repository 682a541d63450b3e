#include "core/measurement/AccuracyTable.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/CleanText.h"
#include "core/base/Csv.h"
#include "core/base/Numbers.h"

namespace vestige {
namespace {

constexpr std::size_t kLongestSentence = 300;
/// Methods that one table compares; names are compared with each other.
constexpr std::size_t kMostColumns = 1000;

std::string trimmed(const std::string& cell) {
    const auto first = cell.find_first_not_of(" \t");
    if (first == std::string::npos) return {};
    return cell.substr(first, cell.find_last_not_of(" \t") - first + 1);
}

/// Where the columns stand in the table.
struct Columns {
    std::size_t object = 0;
    std::size_t tape = 0;
    std::vector<std::size_t> methods;
    std::vector<std::string> names;  ///< of every column
};

class Reader {
  public:
    explicit Reader(std::string file) : file_(std::move(file)) {}

    Columns header(const CsvRow& row) const {
        Columns columns;
        if (row.cells.size() > kMostColumns)
            reject(row.line, "the table has " + std::to_string(row.cells.size()) + " columns",
                   "expected " + std::to_string(kMostColumns) + " at most");
        for (const auto& cell : row.cells) columns.names.push_back(trimmed(cell));
        if (columns.names.size() == 1 && columns.names[0].find(';') != std::string::npos)
            reject(row.line, "the columns are parted by ';'",
                   "expected ',' between them, and '.' in numbers");
        const auto find = [&](const std::string& name) {
            const auto found = std::find(columns.names.begin(), columns.names.end(), name);
            if (found == columns.names.end())
                reject(row.line, "the table has no column '" + name + "'",
                       "expected the columns object,tape_m,<name>_m,...");
            return static_cast<std::size_t>(found - columns.names.begin());
        };
        columns.object = find("object");
        columns.tape = find("tape_m");
        for (std::size_t i = 0; i < columns.names.size(); ++i) {
            if (std::count(columns.names.begin(), columns.names.end(), columns.names[i]) > 1)
                reject(row.line, "the column '" + columns.names[i] + "' stands there twice", {});
            if (i == columns.object || i == columns.tape) continue;
            if (columns.names[i].size() < 3 || !columns.names[i].ends_with("_m"))
                reject(row.line, "column " + std::to_string(i + 1) + " is called '" + columns.names[i] + "'",
                       "expected <name>_m, the lengths measured by the method <name> in metres");
            columns.methods.push_back(i);
        }
        if (columns.methods.empty())
            reject(row.line, "the table has no column of measured lengths",
                   "expected the columns object,tape_m,<name>_m,...");
        return columns;
    }

    std::optional<double> length(const CsvRow& row, const Columns& columns, std::size_t column) const {
        const std::string text = trimmed(row.cells[column]);
        if (text.empty()) return std::nullopt;
        const auto value = parseReal(text);
        if (!value || !std::isfinite(*value) || *value < 0)
            reject(row.line, "'" + text + "' in the column '" + columns.names[column] + "' is not a length",
                   "expected metres such as 4.93, or nothing where it was not measured");
        return value;
    }

    AccuracyObject object(const CsvRow& row, const Columns& columns) const {
        if (row.cells.size() != columns.names.size())
            reject(row.line, "the row has " + std::to_string(row.cells.size()) + " cells",
                   "expected " + std::to_string(columns.names.size()) + ", as in the first row");
        AccuracyObject object;
        object.object = trimmed(row.cells[columns.object]);
        if (object.object.empty())
            reject(row.line, "the cell in the column 'object' is empty", "expected a name");
        const auto tape = length(row, columns, columns.tape);
        if (!tape || *tape == 0)
            reject(row.line, "the column 'tape_m' holds no length",
                   "expected the taped length in metres, above 0");
        object.tape_m = *tape;
        return object;
    }

    [[noreturn]] void reject(std::size_t line, const std::string& message, std::string hint) const {
        throw ErrorException{{ErrorCode::input, cleanText(message, kLongestSentence),
                              file_ + ":" + std::to_string(line), std::move(hint)}};
    }

  private:
    std::string file_;
};

std::vector<MethodAccuracy> tableAccuracy(const std::vector<CsvRow>& rows, const Reader& reader) {
    if (rows.empty())
        reader.reject(1, "the table is empty", "expected the columns object,tape_m,<name>_m,...");
    const Columns columns = reader.header(rows.front());
    if (rows.size() < 2) reader.reject(rows.front().line, "the table has no row below its first", {});
    std::vector<std::vector<AccuracyObject>> objects(columns.methods.size());
    for (std::size_t r = 1; r < rows.size(); ++r) {
        AccuracyObject object = reader.object(rows[r], columns);
        for (std::size_t m = 0; m < columns.methods.size(); ++m) {
            object.measured_m = reader.length(rows[r], columns, columns.methods[m]);
            objects[m].push_back(object);
        }
    }
    std::vector<MethodAccuracy> methods;
    for (std::size_t m = 0; m < columns.methods.size(); ++m) {
        const std::string& column = columns.names[columns.methods[m]];
        methods.push_back(methodAccuracy(column.substr(0, column.size() - 2), objects[m]));
    }
    return methods;
}

}  // namespace

Result<std::vector<MethodAccuracy>> readAccuracyTable(const std::filesystem::path& csv) {
    return guarded(csv.string(), [&]() -> Result<std::vector<MethodAccuracy>> {
        auto rows = readCsv(csv);
        if (!rows) return fail(rows.error());
        return tableAccuracy(*rows, Reader(csv.string()));
    });
}

}  // namespace vestige
