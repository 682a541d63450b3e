#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/PointCloud.h"
#include "core/io/PointField.h"

namespace vestige {

/// The nearest integer that an unsigned `Number` holds; 0 where the value is no number.
template <class Number>
Number nearestInteger(double value) {
    static_assert(!std::numeric_limits<Number>::is_signed && sizeof(Number) <= 4,
                  "a double holds its limits");
    if (std::isnan(value)) return 0;
    return static_cast<Number>(
        std::nearbyint(std::clamp(value, 0.0, static_cast<double>(std::numeric_limits<Number>::max()))));
}

/// Adds a point's value of a field that is one number: intensity, classification, time, source and returns.
/// Other fields add nothing.
void appendValue(PointAttributes& attributes, PointField field, double value);

}  // namespace vestige
