#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/geometry/NeighbourIndex.h"

namespace vestige {

/// The unit normal of the plane through each point's `neighbours` nearest points (itself among them), either
/// way round. `index` is of `points`.
std::vector<Eigen::Vector3f> surfaceNormals(const NeighbourIndex& index,
                                            std::span<const Eigen::Vector3f> points, std::size_t neighbours);

}  // namespace vestige
