#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/registration/ndt/VoxelGrid.h"

namespace vestige {

/// The points of one voxel by their moments, metres in the registration's own frame.
struct CellMoments {
    std::uint64_t key;             ///< of the voxel, see VoxelGrid
    std::uint32_t count;           ///< points
    std::array<float, 3> mean;     ///< their centroid
    std::array<float, 6> scatter;  ///< sum of (y - mean)(y - mean)^T: xx xy xz yy yz zz

    Eigen::Vector3d meanVector() const { return {mean[0], mean[1], mean[2]}; }
    Eigen::Matrix3d scatterMatrix() const;
};

/// The moments of every non-empty voxel. The order of the cells, and every bit of them, is the
/// same for any thread count.
std::vector<CellMoments> gatherPoints(std::span<const Eigen::Vector3f> points, const VoxelGrid& grid);

/// Larger voxels out of smaller ones by their moments: each small voxel goes whole where its centroid lies,
/// so a large one's faces are uneven by up to the small one's size.
std::vector<CellMoments> gatherCells(std::span<const CellMoments> cells, const VoxelGrid& grid);

/// The cells of a grid without shift of edge `size`, and those of twice, four times ... this size up to
/// `coarsest`.
std::vector<std::vector<CellMoments>> gatherStages(std::span<const Eigen::Vector3f> points, double size,
                                                   double coarsest);

}  // namespace vestige
