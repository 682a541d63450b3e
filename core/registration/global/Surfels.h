#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/base/JobControl.h"
#include "core/geometry/PointCloud.h"

namespace vestige {

/// A cloud thinned to one point per voxel, each with the normal of the surface round it, for the search of a
/// first pose. Metres, offsets from `origin`. A normal's sign means nothing: no view point is known.
struct Surfels {
    double voxel_m = 0;
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< scale times the file's coordinates
    std::vector<Eigen::Vector3f> points;
    std::vector<Eigen::Vector3f> normals;  ///< unit length

    std::size_t size() const { return points.size(); }
    /// The surfels `indices`, in their order.
    Surfels select(const std::vector<std::uint32_t>& indices) const;
};

/// Surfels of a cloud whose unit is `scale` metres. A point with too few neighbours within 2.5 voxels for a
/// normal is left out. Bit-identical for any thread count. Throws ErrorException.
Surfels surfelsOf(const PointCloud& cloud, double scale, double voxel_m, const JobControl& control);

/// Indices of at most `count` of 0 ... size - 1, spread evenly.
std::vector<std::uint32_t> spreadIndices(std::size_t size, std::size_t count);

}  // namespace vestige
