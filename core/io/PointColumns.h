#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/PointCloud.h"
#include "core/io/FileInfo.h"
#include "core/io/ScalarType.h"

namespace vestige {

/// Puts coordinates back on the grid (scale and offset) that they were read from, so that a float offset's
/// rounding does not show in a written file. Coordinates off the grid, moved ones for instance, stay as they
/// are.
class SourceGrid {
  public:
    explicit SourceGrid(const FileInfo* source);
    Eigen::Vector3d operator()(const Eigen::Vector3d& point) const;

  private:
    std::optional<Eigen::Vector3d> scale_;
    Eigen::Vector3d offset_ = Eigen::Vector3d::Zero();
};

/// One column of a point file to write; value(i) is that of point i.
struct PointColumn {
    std::string name;
    ScalarType type;
    std::function<double(std::size_t)> value;
};

/// Coordinates as float64, then the attributes that the cloud has, under the names that readers know. The
/// cloud must outlive the columns.
std::vector<PointColumn> pointColumns(const PointCloud& cloud, const SourceGrid& grid);

/// True when every channel is a byte times 257, so that bytes hold the colours exactly.
bool colorsAreBytes(const PointCloud& cloud);

}  // namespace vestige
