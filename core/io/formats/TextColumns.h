#pragma once

#include <vector>

#include "core/io/PointField.h"

namespace vestige {

/// Guesses what the columns of a file without a header are from sample rows of equal length (3 or more): x,
/// y, z, then intensity, colour (whole numbers up to 255 or 65535, or fractions) and normals (unit length) in
/// any of the orders in use. What fits nothing is `none`.
std::vector<PointField> guessColumns(const std::vector<std::vector<double>>& rows);

}  // namespace vestige
