#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>

#include "core/geometry/PointCloudBuilder.h"
#include "core/io/FileFormat.h"
#include "core/io/PointField.h"
#include "core/io/ReadJob.h"
#include "core/io/formats/TileAttributes.h"

namespace vestige {

/// Collects the points of many tiles, in the order in which they come, as one cloud, and leaves out at once
/// what the options leave out. An attribute that only some tiles have is zero in the others.
class TileCloud {
  public:
    explicit TileCloud(const ReadOptions& options);

    /// From here on every kept point has these attributes; `points` at most will come.
    void beginTile(const TileAttributes& attributes, std::size_t points);
    /// False when the options leave the point out; then none of its attributes is to be added.
    bool add(const Eigen::Vector3d& point);
    void addColor(const Color& color) { builder_.attributes().color.push_back(color); }
    void addNormal(const Eigen::Vector3f& normal) { builder_.attributes().normal.push_back(normal); }
    void addValue(PointField field, double value);
    /// Whether the options want this field.
    bool wants(PointField field) const { return all_ || field == PointField::intensity; }

    std::size_t size() const { return builder_.size(); }
    /// The cloud described under the format's name, options heeded. Warns of attributes that not all tiles
    /// have. Leaves this empty.
    LoadedGeometry finish(std::string format, std::string version, ReadJob& job) &&;

  private:
    void padAttributes();

    PointCloudBuilder builder_;
    std::optional<BoundingBox> box_;
    std::size_t keepEvery_;
    bool all_;
    std::size_t met_ = 0;
    TileAttributes any_;
    bool partial_ = false;
    bool first_ = true;
};

}  // namespace vestige
