#include "core/io/formats/TextColumns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace vestige {
namespace {

using Rows = std::vector<std::vector<double>>;

bool areNormals(const Rows& rows, std::size_t column) {
    std::size_t unit = 0;
    for (const auto& row : rows) {
        const double length = std::hypot(row[column], row[column + 1], row[column + 2]);
        if (std::abs(length - 1) < 0.01 || length == 0) ++unit;
    }
    bool allZero = true;
    for (const auto& row : rows)
        for (std::size_t i = column; i < column + 3; ++i) allZero = allZero && row[i] == 0;
    return !allZero && unit >= rows.size() - rows.size() / 20;
}

bool areColors(const Rows& rows, std::size_t column) {
    bool whole = true;
    double largest = 0;
    for (const auto& row : rows)
        for (std::size_t i = column; i < column + 3; ++i) {
            if (!(row[i] >= 0)) return false;
            whole = whole && row[i] == std::floor(row[i]);
            largest = std::max(largest, row[i]);
        }
    return whole ? largest <= 65535 : largest <= 1;
}

/// One letter for each group behind x, y, z: i intensity, c colour, n normal.
bool fits(const Rows& rows, std::string_view groups, std::size_t columns) {
    std::size_t column = 3;
    for (const char group : groups) {
        if (column + (group == 'i' ? 1 : 3) > columns) return false;
        if (group == 'c' && !areColors(rows, column)) return false;
        if (group == 'n' && !areNormals(rows, column)) return false;
        column += group == 'i' ? 1 : 3;
    }
    return column == columns;
}

}  // namespace

std::vector<PointField> guessColumns(const Rows& rows) {
    using enum PointField;
    const std::size_t columns = rows.front().size();
    std::vector<PointField> fields{x, y, z};
    // The likeliest first: PTS writes intensity before colour, scanners write normals last.
    constexpr std::array<std::string_view, 12> kOrders{"",   "i",  "n",  "c",  "ic",  "in",
                                                       "ci", "ni", "cn", "nc", "icn", "cni"};
    const auto order = std::find_if(kOrders.begin(), kOrders.end(),
                                    [&](std::string_view groups) { return fits(rows, groups, columns); });
    for (const char group : order == kOrders.end() ? std::string_view("i") : *order) {
        if (group == 'i') fields.push_back(intensity);
        if (group == 'c') fields.insert(fields.end(), {red, green, blue});
        if (group == 'n') fields.insert(fields.end(), {normalX, normalY, normalZ});
    }
    fields.resize(columns, none);
    return fields;
}

}  // namespace vestige
