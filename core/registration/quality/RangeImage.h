#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/registration/quality/SurfaceCells.h"

namespace vestige {

/// How many rays meet a piece of surface, by where they end.
struct RayCounts {
    int on = 0;      ///< within the margin of its plane
    int behind = 0;  ///< further on: they went through it
    int before = 0;  ///< short of it: it is hidden from them

    int all() const { return on + behind + before; }
};

/// The rays from a viewpoint to a cloud's points, sorted by direction into the pixels of a cube's faces.
class RangeImage {
  public:
    /// Takes at most some two hundred thousand of the points, evenly.
    RangeImage(std::span<const Eigen::Vector3f> points, const Eigen::Vector3d& viewpoint);

    const Eigen::Vector3d& viewpoint() const { return viewpoint_; }
    std::size_t rays() const { return points_.size(); }
    /// The rays that meet the cell's plane within its extent (1.5 standard deviations); none where they would
    /// graze it or it is too near. The cell is in the cloud's frame.
    RayCounts meeting(const SurfaceCell& cell, double margin_m) const;

  private:
    Eigen::Vector3d viewpoint_;
    int side_ = 1;                         ///< pixels along an edge of a face
    std::vector<std::uint32_t> begins_;    ///< of each pixel's points, by face, row, column
    std::vector<Eigen::Vector3f> points_;  ///< from the viewpoint, in the order of their pixels
};

}  // namespace vestige
