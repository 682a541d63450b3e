#include "core/filters/CellLayout.h"

#include <algorithm>
#include <bit>

namespace vestige {
namespace {

using Cell = Eigen::Array<std::int64_t, 3, 1>;

/// Coordinates in cells up to here have their whole number and half a cell or better.
constexpr double kFarthestCell = 1ULL << 52;

double farthest(const BoundingBox& bounds) {
    return bounds.min.cwiseAbs().cwiseMax(bounds.max.cwiseAbs()).maxCoeff();
}

Cell cellsOf(const Eigen::Vector3d& world, double size) {
    const double perSize = 1 / size;
    return {CellLayout::cellOf(world.x(), perSize), CellLayout::cellOf(world.y(), perSize),
            CellLayout::cellOf(world.z(), perSize)};
}

}  // namespace

bool CellLayout::covers(const BoundingBox& bounds, double size) {
    if (bounds.empty()) return true;
    if (!(farthest(bounds) / size < kFarthestCell)) return false;
    const Cell cells = cellsOf(bounds.max, size) - cellsOf(bounds.min, size);
    // One empty cell on either side.
    return cells.maxCoeff() + 3 <= static_cast<std::int64_t>(kMostCells);
}

double CellLayout::coveringSize(const BoundingBox& bounds, double size) {
    if (bounds.empty()) return size;
    const double longest = bounds.extent().maxCoeff();
    return std::max(
        {size, longest / static_cast<double>(kMostCells - 8), 2 * farthest(bounds) / kFarthestCell});
}

CellLayout::CellLayout(const BoundingBox& bounds, double size) : size_(size) {
    base_ = cellsOf(bounds.min, size) - 1;
    counts_ = cellsOf(bounds.max, size) - base_ + 2;
    const auto bits = [&](int axis) {
        return static_cast<unsigned>(std::bit_width(static_cast<std::uint64_t>(counts_[axis] - 1)));
    };
    shiftY_ = bits(2);
    shiftX_ = shiftY_ + bits(1);
    keyBits_ = shiftX_ + bits(0);
}

Cell CellLayout::steps(std::uint64_t key) const {
    const std::uint64_t maskY = (std::uint64_t{1} << (shiftX_ - shiftY_)) - 1;
    const std::uint64_t maskZ = (std::uint64_t{1} << shiftY_) - 1;
    return {static_cast<std::int64_t>(key >> shiftX_), static_cast<std::int64_t>(key >> shiftY_ & maskY),
            static_cast<std::int64_t>(key & maskZ)};
}

Eigen::Vector3d CellLayout::corner(std::uint64_t key) const {
    return (base_ + steps(key)).cast<double>().matrix() * size_;
}

}  // namespace vestige
