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

/// One cloud's moments at sizes b, 2b, 4b, ... and, merged from these, at any other.
class MomentPyramid {
  public:
    /// `finest` is b; no grid of more than `coarsest` will be asked for. Grids that are no stage are gathered
    /// from one of at most a quarter of their size, so b should be that much smaller than the smallest such.
    MomentPyramid(std::span<const Eigen::Vector3f> points, double finest, double coarsest);

    std::vector<CellMoments> at(const VoxelGrid& grid) const;
    /// The stage that is this grid; null when none is.
    const std::vector<CellMoments>* stage(const VoxelGrid& grid) const;

  private:
    const std::vector<CellMoments>& finerThan(double size) const;

    double baseSize_;
    std::vector<std::vector<CellMoments>> stages_;
};

}  // namespace vestige
