#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "core/geometry/BoundingBox.h"

namespace vestige {

/// How the cubic cells of a grid whose corner is the world origin are counted: from one below the first cell
/// of the bounds, along x, y and z; the three counts side by side in one key, x highest.
class CellLayout {
  public:
    /// Cells along each axis.
    static constexpr std::uint64_t kMostCells = std::uint64_t{1} << 21;

    /// Whether cells of this size cover the bounds within kMostCells along each axis.
    static bool covers(const BoundingBox& bounds, double size);
    /// The smallest size from `size` up that covers the bounds.
    static double coveringSize(const BoundingBox& bounds, double size);

    CellLayout() = default;
    /// `bounds` are not empty and covered by `size` > 0.
    CellLayout(const BoundingBox& bounds, double size);

    double size() const { return size_; }
    /// World cell number of count 0 along each axis.
    const Eigen::Array<std::int64_t, 3, 1>& base() const { return base_; }
    /// Counts are below this along each axis, at least for places within the bounds.
    const Eigen::Array<std::int64_t, 3, 1>& counts() const { return counts_; }
    unsigned shiftX() const { return shiftX_; }
    unsigned shiftY() const { return shiftY_; }
    unsigned keyBits() const { return keyBits_; }

    std::uint64_t key(std::uint64_t x, std::uint64_t y, std::uint64_t z) const {
        return x << shiftX_ | y << shiftY_ | z;
    }
    /// x, y and z of a key.
    Eigen::Array<std::int64_t, 3, 1> steps(std::uint64_t key) const;
    /// World coordinates of a cell's corner of least x, y and z.
    Eigen::Vector3d corner(std::uint64_t key) const;

    /// Number of the cell along one axis that holds a world coordinate.
    static std::int64_t cellOf(double world, double perSize) {
        // std::floor for numbers that fit, without the call.
        const double cells = world * perSize;
        const auto whole = static_cast<std::int64_t>(cells);
        return whole - (static_cast<double>(whole) > cells);
    }

  private:
    double size_ = 1;
    unsigned shiftX_ = 0;
    unsigned shiftY_ = 0;
    unsigned keyBits_ = 0;
    Eigen::Array<std::int64_t, 3, 1> base_ = {0, 0, 0};
    Eigen::Array<std::int64_t, 3, 1> counts_ = {0, 0, 0};
};

}  // namespace vestige
