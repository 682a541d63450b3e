#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/PointField.h"

namespace vestige {

/// How a text file of points is laid out, found by looking at its beginning.
struct TextLayout {
    std::vector<PointField> fields;  ///< of the columns
    char separator = ' ';            ///< blank: any run of blanks, else ',' or ';'
    std::size_t bodyOffset = 0;      ///< where the first row begins
    std::size_t bodyLine = 1;
    std::optional<std::size_t> promised;  ///< points, by the count that a PTS file begins with
    std::string description;              ///< "x y z intensity", for people
};

/// Recognises header, separator and columns; a PTS file's count is passed over. Refuses, at its line, what is
/// neither a row of numbers nor a row of names with x, y and z.
TextLayout recogniseLayout(std::string_view text, ReadJob& job);

/// The cells of one line as numbers, into `row`; the number of cells. A cell that is empty or no number ends
/// the row: `bad` is set to its number from 1, else to 0. Cells beyond the length of `row` are counted only.
std::size_t splitNumbers(std::string_view line, char separator, std::vector<double>& row, std::size_t& bad);

/// Comments begin with #, //, ;, % or !.
bool isComment(std::string_view line);

}  // namespace vestige
