#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/geometry/PointCloud.h"

namespace vestige {

/// What PCL offers for the same work, on its own cloud of the same offsets.
class PclFilters {
  public:
    explicit PclFilters(const PointCloud& cloud);
    ~PclFilters();

    /// pcl::VoxelGrid; the number of points left. `allFields` is PCL's standard setting, without it only
    /// coordinates are averaged.
    std::size_t voxelGrid(float size, bool allFields) const;
    /// The mean of the neighbours that pcl::KdTreeFLANN finds within the radius; the sum of all z. PCL has no
    /// such filter of its own.
    double meanFilter(float radius) const;
    /// pcl::StatisticalOutlierRemoval; the indices of the points left.
    std::vector<std::int32_t> statistical(int neighbours, double sigmas) const;

  private:
    struct Cloud;
    std::unique_ptr<Cloud> cloud_;
};

}  // namespace vestige
