#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/registration/ndt/VoxelGrid.h"

namespace vestige {

/// All neighbours of all points within one radius, found cell by cell: what is near a cell is gathered once
/// for all its points. Metres. The points must outlive it.
class NeighbourCells {
  public:
    NeighbourCells(std::span<const Eigen::Vector3f> points, float radius);

    struct Neighbour {
        std::uint32_t point;
        float squaredDistance;
    };
    /// Calls `use(point, neighbours)` once for every point, many threads at once; the point itself is not
    /// among its neighbours, which come in an order that depends on the points alone.
    using Use = std::function<void(std::uint32_t, std::span<const Neighbour>)>;
    void forEach(const Use& use) const;

  private:
    struct Cell {
        std::uint64_t key;
        std::uint32_t begin;
        std::uint32_t end;
    };
    /// The ranges of order_ that lie in the 27 cells round this one.
    void gather(std::size_t cell, std::vector<std::uint32_t>& near) const;

    std::span<const Eigen::Vector3f> points_;
    float radius_;
    VoxelGrid grid_;
    std::vector<std::uint32_t> order_;  ///< points by cell
    std::vector<Cell> cells_;           ///< by key
};

}  // namespace vestige
