#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/JobControl.h"
#include "core/filters/CellLayout.h"
#include "core/filters/CellMembers.h"
#include "core/geometry/PointCloud.h"

namespace vestige {

/// The points of a cloud sorted into the cubic cells of a grid whose corner is the world origin, so that the
/// cells do not depend on the cloud's own origin. Cells come in ascending order of their index along x, then
/// y, then z; the points of one cell in ascending order of their own index.
class CellGrid {
  public:
    /// `size` > 0 covers the cloud (CellLayout). Throws ErrorException when the job is cancelled.
    CellGrid(const PointCloud& cloud, double size, const JobControl& control);

    double size() const { return layout_.size(); }
    std::size_t cellCount() const { return keys_.size(); }
    const CellMembers& members() const { return members_; }
    /// Indices into the cloud, cell after cell.
    std::span<const std::uint32_t> order() const { return members_.order; }
    /// The range of a cell, or of consecutive cells, in order().
    std::uint32_t begin(std::size_t cell) const { return members_.begins[cell]; }
    std::uint32_t end(std::size_t cell) const { return members_.begins[cell + 1]; }
    std::span<const std::uint32_t> points(std::size_t cell) const { return members_.points(cell); }
    /// x, y and z of the cell as one number, x highest, counted from one below the cloud's first cell: a
    /// neighbour's key is this one plus the key of the steps, without overflow from axis to axis.
    std::uint64_t key(std::size_t cell) const { return keys_[cell]; }
    std::uint64_t key(std::uint64_t x, std::uint64_t y, std::uint64_t z) const {
        return layout_.key(x, y, z);
    }
    /// World coordinates of the cell's corner of least x, y and z.
    Eigen::Vector3d corner(std::size_t cell) const { return layout_.corner(keys_[cell]); }
    /// The first cell whose key is not below this one; cellCount() when there is none.
    std::size_t firstCell(std::uint64_t key) const;

  private:
    template <class Key>
    void sortPoints(const PointCloud& cloud, const JobControl& control);

    CellLayout layout_;
    CellMembers members_;
    std::vector<std::uint64_t> keys_;
};

}  // namespace vestige
