#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>

#include "core/geometry/PointCloud.h"

namespace vestige {

/// Collects points in world coordinates and makes the immutable PointCloud. The origin is the one given, or
/// the first point rounded to whole units. Points further than `kExactRange` from it keep a residual, so no
/// cloud loses digits, however large.
class PointCloudBuilder {
  public:
    /// Up to here a float offset is good to 0.016 mm (for metres).
    static constexpr float kExactRange = 256;

    PointCloudBuilder() = default;
    explicit PointCloudBuilder(Eigen::Vector3d origin) : origin_(std::move(origin)) {}

    void reserve(std::size_t count);
    void add(const Eigen::Vector3d& world);
    std::size_t size() const { return offsets_.size(); }

    /// For filling in parallel: resize, then setPoint for every index. Needs an origin given to the
    /// constructor.
    void resize(std::size_t count);
    void setPoint(std::size_t i, const Eigen::Vector3d& world);

    PointAttributes& attributes() { return attributes_; }

    /// Leaves the builder empty.
    PointCloud build() &&;

  private:
    std::optional<Eigen::Vector3d> origin_;
    LargeArray<Eigen::Vector3f> offsets_;
    LargeArray<Eigen::Vector3f> residuals_;
    PointAttributes attributes_;
};

}  // namespace vestige
