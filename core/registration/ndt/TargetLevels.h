#pragma once

#include <string>
#include <vector>

#include "core/registration/ndt/CellMoments.h"
#include "core/registration/ndt/ImprovedNdt.h"
#include "core/registration/ndt/MomentPyramid.h"

namespace vestige {

/// The target at every voxel size that a registration goes through.
class TargetLevels {
  public:
    /// Edge of the smallest cells that are ever gathered.
    static double finestCell(const ImprovedNdtOptions& options);
    TargetLevels(std::span<const Eigen::Vector3f> target, const ImprovedNdtOptions& options);

    /// The sizes that are registered with whole cells, from v0 down: how many, and what one of them sees,
    /// from large to small.
    std::size_t wholeLevels() const { return sizes_.size(); }
    double size(std::size_t level) const { return sizes_[level]; }
    std::span<const NormalDistributions> seen(std::size_t level) const;
    double smallest() const { return smallest_; }
    double rangeNoise_m() const { return options_.distributions.rangeNoise_m; }
    const std::vector<std::string>& notes() const { return notes_; }

    /// The flat cells from `finest` up to largestSurface(), from large to small, as thin as their points lie
    /// but no thinner than `deviation_m`; all cells where the flat ones hold too little of the target.
    std::vector<NormalDistributions> surfaces(double deviation_m, double finest) const;
    double largestSurface() const;
    /// Copies of the last of surfaces(), shifted along the diagonal.
    std::vector<NormalDistributions> shiftedSurfaces(double deviation_m) const;

  private:
    void choose(std::size_t targetPoints);
    NormalDistributions at(const VoxelGrid& grid, const DistributionOptions& options) const;
    DistributionOptions surfaceOptions(double deviation_m) const;

    ImprovedNdtOptions options_;
    MomentPyramid pyramid_;
    std::vector<double> sizes_;
    /// Of each size; before them (published: not) v0 shifted by half a cell, for what lies just beyond a face
    /// that all sizes share.
    std::vector<NormalDistributions> cells_;
    double smallest_ = 0;
    bool flatHold_ = true;
    std::vector<std::string> notes_;
};

}  // namespace vestige
