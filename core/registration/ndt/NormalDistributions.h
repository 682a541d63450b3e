#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/registration/ndt/CellMoments.h"
#include "core/registration/ndt/VoxelGrid.h"

namespace vestige {

struct DistributionOptions {
    double outlierRatio = 0.1;        ///< rho of METHOD section 3, step 3
    double flatness = 0.005;          ///< T: a cell is flat when f <= T
    double rangeNoise_m = 0;          ///< s: taken off the smallest eigenvalue before f
    bool flatCellsInPlane = false;    ///< classic: flat cells hold points in their plane too
    std::uint32_t minimumPoints = 6;  ///< a cell with fewer is left out
    bool flatOnly = false;            ///< cells that are not flat are left out
    /// Standard deviations are lifted to this share of the cell's largest, and to this length.
    double leastShare = 0.1;
    double leastDeviation_m = 0;
};

/// The normal distribution of one target voxel, ready for scoring; one cache line.
struct alignas(64) NormalCell {
    std::uint64_t key = VoxelGrid::kNoKey;
    std::array<float, 3> mean{};
    std::array<float, 6> information{};  ///< C^-1: xx xy xz yy yz zz
    float depth = 0;                     ///< d1 < 0: score of a point at the mean
    float steepness = 0;                 ///< d2
    std::uint32_t count = 0;             ///< target points
    float thickness = 0;                 ///< square root of the smallest eigenvalue, metres
    bool flat = false;                   ///< f <= T and wide in two directions
};

/// How flat the cells of one voxel size are (METHOD section 3, step 2): only cells with ten points and an
/// extent in two directions vote.
struct FlatnessCount {
    double voxel_m = 0;
    std::size_t cells = 0;       ///< that vote
    std::size_t flat = 0;        ///< of these
    std::size_t points = 0;      ///< in these
    std::size_t flatPoints = 0;  ///< in the flat ones
    double ratio() const { return cells == 0 ? 0 : static_cast<double>(flat) / static_cast<double>(cells); }
};

/// METHOD section 3, step 1: the target at one voxel size.
class NormalDistributions {
  public:
    NormalDistributions(std::span<const CellMoments> moments, const VoxelGrid& grid,
                        const DistributionOptions& options);

    /// The cell that holds the point (metres, registration's frame); null where there is none.
    const NormalCell* find(double x, double y, double z) const { return findKey(grid_.key(x, y, z)); }
    const NormalCell* findKey(std::uint64_t key) const {
        std::uint32_t slot = VoxelGrid::hash(key) & mask_;
        while (keys_[slot] != key) {
            if (keys_[slot] == VoxelGrid::kNoKey) return nullptr;
            slot = (slot + 1) & mask_;
        }
        return key == VoxelGrid::kNoKey ? nullptr : &table_[slot];
    }
    const VoxelGrid& grid() const { return grid_; }
    /// Open addressing with linear probing; `mask()` + 1 slots, those without a cell have kNoKey.
    const NormalCell* table() const { return table_.data(); }
    /// The keys of the slots once more, close together: most of a search's steps find nothing.
    const std::uint64_t* keys() const { return keys_.data(); }
    std::uint32_t mask() const { return mask_; }
    std::size_t size() const { return count_; }
    const FlatnessCount& flatness() const { return flatness_; }

  private:
    VoxelGrid grid_;
    std::vector<NormalCell> table_;
    std::vector<std::uint64_t> keys_;
    std::uint32_t mask_ = 0;
    std::size_t count_ = 0;
    FlatnessCount flatness_;
};

/// The thickness (standard deviation, metres) that a quarter of the voting cells stay below: what the range
/// noise of a target looks like where its surfaces are flat. 0 when no cell votes.
double surfaceThickness(std::span<const CellMoments> moments);

}  // namespace vestige
