#pragma once

#include <Eigen/Core>
#include <string_view>

namespace vestige {

/// The largest coordinate that is read, in the file's unit. The Earth's centre is 6.4e9 mm away; between
/// points that lie twice this far apart a cloud still holds 0.1 mm (docs/decisions/0017-hostile-files.md).
inline constexpr double kLargestCoordinate = 1e10;

/// Finite and not beyond kLargestCoordinate; false for what is no number.
inline bool isUsable(const Eigen::Vector3d& point) {
    return (point.array().abs() <= kLargestCoordinate).all();
}

/// What is wrong with a point that is not usable, and what was expected.
inline constexpr std::string_view kUnusableCoordinate =
    "a coordinate is no finite number, or farther from 0 than any place on Earth";
inline constexpr std::string_view kUsableCoordinates = "finite coordinates up to 1e10";

}  // namespace vestige
