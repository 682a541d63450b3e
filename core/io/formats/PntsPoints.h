#pragma once

#include <Eigen/Core>

#include "core/io/formats/PntsTables.h"
#include "core/io/formats/TileCloud.h"

namespace vestige {

/// Adds the points of a tile whose Draco stream, if any, is decoded. `rootFromTile` is affine; positions are
/// its product with RTC_CENTER + POSITION, all in double, normals follow its inverse transpose. Refuses
/// coordinates that are no finite numbers and batch numbers that the tile does not have.
void addPntsPoints(const PntsTables& tables, const Eigen::Matrix4d& rootFromTile, TileCloud& cloud,
                   ReadJob& job);

/// A unit vector from two bytes (3D Tiles 1.0, "Oct-encoded normal vectors"; Meyer et al. 2010).
Eigen::Vector3f octNormal(std::uint8_t x, std::uint8_t y);

}  // namespace vestige
