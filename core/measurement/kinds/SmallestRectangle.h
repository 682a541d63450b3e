#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>

namespace vestige {

/// The rectangle of smallest area that holds points of a plane: its corners in turn. Nothing where the points
/// lie on one line. One of its sides lies along a side of the convex hull (Freeman and Shapira, Comm. ACM 18,
/// 1975).
std::optional<std::array<Eigen::Vector2d, 4>> smallestRectangle(std::span<const Eigen::Vector2d> points);

}  // namespace vestige
