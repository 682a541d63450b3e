#pragma once

#include "core/filters/CellMembers.h"
#include "core/geometry/PointCloud.h"

namespace vestige {

/// One value per cell of each attribute that the cloud has. Quantities are averaged (intensity, colour, GPS
/// time; normals to unit length, or zero where they cancel out); of labels, which have no mean
/// (classification, point source, return number and count), the most frequent, ties to the lowest.
PointAttributes averagedAttributes(const PointAttributes& attributes, const CellMembers& cells);

}  // namespace vestige
