#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/LargeArray.h"
#include "core/geometry/BoundingBox.h"
#include "core/geometry/CoordinateGrid.h"
#include "core/geometry/Intensities.h"
#include "core/geometry/Pose.h"

namespace vestige {

/// 16 bits a channel, as LAS has them; 8-bit colours are held times 257, which reads back exactly.
using Color = std::array<std::uint16_t, 3>;

/// Per-point attributes. Each array is empty (the cloud does not have it) or as long as the cloud.
struct PointAttributes {
    Intensities intensity;  ///< as in the file, no range implied
    LargeArray<Color> color;
    std::vector<std::uint8_t> classification;  ///< ASPRS classes
    std::vector<double> gpsTime;             ///< s, as in the file (GPS week time or adjusted standard time)
    std::vector<Eigen::Vector3f> normal;     ///< unit length or zero
    std::vector<std::uint16_t> pointSource;  ///< LAS point source ID
    std::vector<std::uint8_t> returnNumber;
    std::vector<std::uint8_t> returnCount;

    /// The attributes of the points `indices`, in their order.
    PointAttributes select(std::span<const std::uint32_t> indices) const;
};

/// Points in world coordinates, held as float offsets round the cloud's own double origin. Immutable once
/// built (see PointCloudBuilder) and then shared between scene, view and jobs.
class PointCloud {
  public:
    PointCloud() = default;
    /// `residuals` is empty or as long as `offsets`: what a float offset cannot hold of points far from the
    /// origin.
    PointCloud(Eigen::Vector3d origin, LargeArray<Eigen::Vector3f> offsets,
               LargeArray<Eigen::Vector3f> residuals, PointAttributes attributes);
    /// A cloud whose points lie on a grid that float offsets can tell (CoordinateGrid::heldByFloats), all
    /// finite, within the box `bounds`, which they fill.
    PointCloud(Eigen::Vector3d origin, LargeArray<Eigen::Vector3f> offsets, const CoordinateGrid& grid,
               const BoundingBox& bounds, PointAttributes attributes);

    std::size_t size() const { return offsets_.size(); }
    bool empty() const { return offsets_.empty(); }

    const Eigen::Vector3d& origin() const { return origin_; }
    /// World = origin + offset, to half a float ulp of the offset (0.03 mm at 500 m); what numerical kernels
    /// use.
    const LargeArray<Eigen::Vector3f>& offsets() const { return offsets_; }
    const LargeArray<Eigen::Vector3f>& residuals() const { return residuals_; }
    /// World coordinates of point i, exact as read.
    Eigen::Vector3d point(std::size_t i) const {
        Eigen::Vector3d world = origin_ + offsets_[i].cast<double>();
        if (grid_) return grid_->snapped(world);
        if (!residuals_.empty()) world += residuals_[i].cast<double>();
        return world;
    }

    /// The grid of its file, where it is held by it; such a cloud has no residuals.
    const std::optional<CoordinateGrid>& grid() const { return grid_; }

    const PointAttributes& attributes() const { return attributes_; }
    /// World bounds; empty for an empty cloud.
    const BoundingBox& bounds() const { return bounds_; }

    /// The points `indices` in their order, with their attributes and the same origin.
    PointCloud select(std::span<const std::uint32_t> indices) const;
    /// Every point (and normal) moved; the origin moves along in double. A cloud that is given away is moved
    /// in place: beside it there are at most the residuals that it lacks (12 bytes a point).
    PointCloud transformed(const Similarity& toFromHere) const&;
    PointCloud transformed(const Similarity& toFromHere) &&;
    /// The same points with other attributes.
    PointCloud withAttributes(PointAttributes attributes) const;
    /// Without time, source, returns, and classes that are all 0 (ReadOptions::Attributes::drawn); in place.
    void keepDrawnAttributes();

  private:
    void findBounds();

    Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
    LargeArray<Eigen::Vector3f> offsets_;
    LargeArray<Eigen::Vector3f> residuals_;
    std::optional<CoordinateGrid> grid_;
    PointAttributes attributes_;
    BoundingBox bounds_;
};

}  // namespace vestige
