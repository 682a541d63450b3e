#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/geometry/PointCloudBuilder.h"
#include "core/io/PointField.h"

namespace vestige {

/// How a file's colour numbers are meant. `guess`: by the largest value, up to 1 fractions, up to 255 bytes,
/// else 16 bits.
enum class ColorDepth { bytes, words, guess };

/// Collects rows of numbers, one per point, as the cloud that their fields describe.
class PointSink {
  public:
    PointSink(const std::vector<PointField>& fields, ColorDepth depth);

    /// `row` is as long as `fields`. False, and nothing is added, when a coordinate is not usable.
    bool add(const double* row);
    std::size_t size() const { return builder_.size(); }
    void reserve(std::size_t points) { builder_.reserve(points); }

    /// Leaves the sink empty.
    PointCloud build() &&;

  private:
    void addColor(double red, double green, double blue);
    void finishColors();

    PointCloudBuilder builder_;
    std::vector<std::pair<PointField, std::size_t>> columns_;
    std::size_t x_ = 0, y_ = 0, z_ = 0;
    std::optional<std::size_t> red_, green_, blue_, normalX_, normalY_, normalZ_;
    ColorDepth depth_;
    std::vector<Eigen::Vector3f> undecidedColors_;
};

/// Unit length or zero, whatever the file says.
Eigen::Vector3f cleanNormal(const Eigen::Vector3d& normal);

}  // namespace vestige
