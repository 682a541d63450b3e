#pragma once

#include <span>
#include <vector>

#include "core/registration/ndt/CellMoments.h"

namespace vestige {

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
