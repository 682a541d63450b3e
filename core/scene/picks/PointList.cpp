#include "core/scene/picks/PointList.h"

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

#include "core/base/CleanText.h"
#include "core/base/Numbers.h"
#include "core/scene/picks/DelimitedText.h"

namespace vestige {
namespace {

/// As far from 0 as coordinates of clouds may be.
constexpr double kFarthest = 1e10;
constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};
constexpr const char* kLayouts =
    "expected x,y,z or index,x,y,z or label,x,y,z, decimal numbers with '.', parted by comma, semicolon, tab "
    "or blanks";

std::optional<double> coordinate(const std::string& cell) {
    const auto value = parseReal(cell);
    // Also catches what is no number.
    if (!value || !(std::abs(*value) <= kFarthest)) return std::nullopt;
    return value;
}

std::optional<std::uint64_t> wholeNumber(const std::string& text) {
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end) return std::nullopt;
    return value;
}

/// A header names the last three columns: x y z, or east north height, with what follows of a unit.
bool isHeader(const std::vector<std::string>& cells) {
    if (cells.size() < 3) return false;
    const auto initial = [&](std::size_t fromEnd) {
        const std::string& cell = cells[cells.size() - fromEnd];
        const std::size_t letter = cell.find_first_not_of("/# ");
        if (letter == std::string::npos) return '\0';
        return static_cast<char>(std::tolower(static_cast<unsigned char>(cell[letter])));
    };
    const std::array<char, 3> found{initial(3), initial(2), initial(1)};
    return found == std::array{'x', 'y', 'z'} || found == std::array{'e', 'n', 'h'};
}

std::string joined(const std::vector<std::string>& cells, std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += (i > 0 ? " " : "") + cells[i];
    return text;
}

Result<ListedPoint> pointOf(const DelimitedRow& row, bool blanks, const std::string& place) {
    const std::string line = place + " line " + std::to_string(row.line);
    const std::size_t count = row.cells.size();
    // Parted by blanks, a label may have some itself.
    if (count < 3 || (count > 4 && !blanks))
        return fail(ErrorCode::input,
                    count == 1 ? "there is one cell" : "there are " + std::to_string(count) + " cells", line,
                    kLayouts);
    ListedPoint point;
    point.line = row.line;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::string& cell = row.cells[count - 3 + i];
        const auto value = coordinate(cell);
        if (!value)
            return fail(ErrorCode::input,
                        kAxes[i] + std::string(" is not a number: '") + cleanText(cell) + "'", line,
                        "expected a decimal number with '.', up to 1e10");
        point.position[static_cast<Eigen::Index>(i)] = *value;
    }
    point.label = joined(row.cells, count - 3);
    point.index = wholeNumber(point.label);
    return point;
}

Result<std::vector<ListedPoint>> pointsOf(const Result<DelimitedText>& table, const std::string& place) {
    if (!table) return fail(table.error());
    std::vector<ListedPoint> points;
    for (const DelimitedRow& row : table->rows) {
        if (&row == &table->rows.front() && isHeader(row.cells)) continue;
        auto point = pointOf(row, table->separator == ' ', place);
        if (!point) return fail(point.error());
        points.push_back(std::move(*point));
    }
    if (points.empty()) return fail(ErrorCode::input, "there are no points", place, kLayouts);
    return points;
}

}  // namespace

Result<std::vector<ListedPoint>> parsePointList(std::string_view text, const std::string& place) {
    return pointsOf(parseDelimited(text, place), place);
}

Result<std::vector<ListedPoint>> readPointList(const std::filesystem::path& file) {
    return pointsOf(readDelimited(file), file.string());
}

}  // namespace vestige
