#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace vestige {

/// The first point of every cube of side `spacing`, as indices in ascending order: how scanning software
/// fuses overlapping shots to its point distance.
std::vector<std::uint32_t> firstPerCell(const std::vector<Eigen::Vector3f>& points, double spacing);

}  // namespace vestige
