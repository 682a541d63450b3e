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

/// The score of the points [begin, end) with its derivatives by p = (t, r w), in float, eight points at once,
/// summed in double in blocks of 256. `levels` runs from the smallest voxel to the largest: a point counts in
/// the first that has a cell for it. `begin` is a multiple of eight. `radius` turns radians into metres.
NdtSums sumNdt(std::span<const NormalDistributions* const> levels, const PointLanes& points,
               std::size_t begin, std::size_t end, const Pose& pose, double radius);

/// The sum of the score alone.
double sumNdtScore(std::span<const NormalDistributions* const> levels, const PointLanes& points,
                   std::size_t begin, std::size_t end, const Pose& pose);

/// Distance across the cell, (e' C^-1 e / trace C^-1)^1/2, of each point; infinite where no cell holds it.
/// Writes `distances` from `begin` on, in steps of eight.
void surfaceDistancesOf(std::span<const NormalDistributions* const> levels, const PointLanes& points,
                        std::size_t begin, std::size_t end, const Pose& pose, float* distances);

}  // namespace vestige
