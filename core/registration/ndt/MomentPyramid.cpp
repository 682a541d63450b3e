#include "core/registration/ndt/MomentPyramid.h"

#include <cmath>

namespace vestige {

MomentPyramid::MomentPyramid(std::span<const Eigen::Vector3f> points, double finest, double coarsest)
    : baseSize_(finest), stages_(gatherStages(points, finest, coarsest)) {}

const std::vector<CellMoments>& MomentPyramid::finerThan(double size) const {
    std::size_t stage = 0;
    while (stage + 1 < stages_.size() && std::ldexp(baseSize_, static_cast<int>(stage) + 1) <= size) ++stage;
    return stages_[stage];
}

const std::vector<CellMoments>* MomentPyramid::stage(const VoxelGrid& grid) const {
    if (grid.shift() != 0) return nullptr;
    const std::vector<CellMoments>& nearest = finerThan(grid.size() * (1 + 1e-9));
    const auto level = static_cast<int>(&nearest - stages_.data());
    return std::abs(std::ldexp(baseSize_, level) - grid.size()) <= 1e-9 * grid.size() ? &nearest : nullptr;
}

std::vector<CellMoments> MomentPyramid::at(const VoxelGrid& grid) const {
    const std::vector<CellMoments>* const same = stage(grid);
    if (same != nullptr) return *same;
    // Shifted by half a cell, stages still nest.
    const VoxelGrid half(grid.size() / 2);
    const std::vector<CellMoments>* const nested = grid.shift() == half.size() ? stage(half) : nullptr;
    return gatherCells(nested != nullptr ? *nested : finerThan(grid.size() / 4), grid);
}

}  // namespace vestige
