#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/Pose.h"
#include "core/registration/ndt/NormalDistributions.h"

namespace vestige {

/// Points axis by axis in steps of eight; the places left over lie outside every grid.
struct PointLanes {
    std::vector<float> x, y, z;
    std::size_t count = 0;

    explicit PointLanes(std::span<const Eigen::Vector3f> points);
};

/// Sums over source points; the Hessian's upper triangle row by row.
struct NdtSums {
    double score = 0;
    std::size_t inside = 0;
    std::array<double, 6> gradient{};
    std::array<double, 21> hessian{};

    NdtSums& operator+=(const NdtSums& other);
};

/// Where eight points lay when they were last looked up: while they stay in the same voxels of the finest and
/// of the shifted grid, they stay in the same cells.
struct FoundCells {
    static constexpr std::uint32_t kNowhere = 0xffffffff;
    alignas(32) std::array<std::uint32_t, 8> low;
    alignas(32) std::array<std::uint32_t, 8> high;
    alignas(32) std::array<std::uint32_t, 8> shiftedLow;
    alignas(32) std::array<std::uint32_t, 8> shiftedHigh;
    std::array<const NormalCell*, 8> cells;

    FoundCells();
};
/// Whether that holds for these levels: each but the last, which may be shifted, is cut into by the one
/// before.
bool canRemember(std::span<const NormalDistributions* const> levels);

/// The score of the points [begin, end) with its derivatives by p = (t, r w), in float, eight points at once,
/// summed in double in blocks of 256. `levels` runs from the smallest voxel to the largest: a point counts in
/// the first that has a cell for it. `begin` is a multiple of eight. `radius` turns radians into metres.
/// `found` is empty or remembers, for all points of the source, the cells of the poses before.
NdtSums sumNdt(std::span<const NormalDistributions* const> levels, const PointLanes& points,
               std::size_t begin, std::size_t end, const Pose& pose, double radius,
               std::span<FoundCells> found = {});

/// The sum of the score alone.
double sumNdtScore(std::span<const NormalDistributions* const> levels, const PointLanes& points,
                   std::size_t begin, std::size_t end, const Pose& pose);

/// Distance across the cell, (e' C^-1 e / trace C^-1)^1/2, of each point; infinite where no cell holds it.
/// Writes `distances` from `begin` on, in steps of eight.
void surfaceDistancesOf(std::span<const NormalDistributions* const> levels, const PointLanes& points,
                        std::size_t begin, std::size_t end, const Pose& pose, float* distances);

}  // namespace vestige
