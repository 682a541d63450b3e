#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/geometry/PointCloudBuilder.h"
#include "core/io/PointField.h"
#include "core/io/RecordCloud.h"

namespace vestige {

/// Collects rows of numbers, one per point, as the cloud that their fields describe.
class PointSink {
  public:
    PointSink(const std::vector<PointField>& fields, ColorDepth depth);

    /// `row` is as long as `fields`. False, and nothing is added, when a coordinate is not usable.
    bool add(const double* row);
    /// All `points` points of binary records at once, by many threads, into an empty sink; the columns are in
    /// the order of `fields`, whose meaning they get. False, and nothing is added, when a coordinate is not
    /// usable: row by row it is told which.
    bool addRecords(const std::byte* body, std::size_t points, RecordLayout layout, const ReadJob& job);
    std::size_t size() const { return atOnce_ ? atOnce_->size() : builder_.size(); }
    void reserve(std::size_t points) { builder_.reserve(points); }

    /// Leaves the sink empty.
    PointCloud build() &&;

  private:
    void addColor(double red, double green, double blue);
    void finishColors();

    std::vector<PointField> fields_;
    std::optional<PointCloud> atOnce_;
    PointCloudBuilder builder_;
    std::vector<std::pair<PointField, std::size_t>> columns_;
    std::size_t x_ = 0, y_ = 0, z_ = 0;
    std::optional<std::size_t> red_, green_, blue_, normalX_, normalY_, normalZ_;
    ColorDepth depth_;
    std::vector<Eigen::Vector3f> undecidedColors_;
};

}  // namespace vestige
