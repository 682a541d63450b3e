#pragma once

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/geometry/PointCloud.h"

namespace vestige {

enum class OutlierMethod { none, statistical, radius };

struct OutlierOptions {
    OutlierMethod method = OutlierMethod::none;
    int neighbours = 8;  ///< statistical: k
    double sigmas = 3;   ///< statistical: mean + sigmas * SD of the mean neighbour distance is the limit
    double radius = 0;   ///< radius: search radius; 0: 3 times the median local spacing
    int minimumNeighbours = 2;  ///< radius: points with fewer are dropped
};

/// The cloud without its outliers, order and attributes kept. The point itself is no neighbour of its own.
/// ErrorCode::usage for numbers of neighbours below 1, negative sigmas, or a radius outside Spacing.h's
/// bounds.
Result<PointCloud> removeOutliers(const PointCloud& cloud, const OutlierOptions& options,
                                  const JobControl& control = {});

/// The outliers themselves, by ascending index; the same errors.
Result<std::vector<std::uint32_t>> findOutliers(const PointCloud& cloud, const OutlierOptions& options,
                                                const JobControl& control = {});

}  // namespace vestige
