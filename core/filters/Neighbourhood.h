#pragma once

#include <string_view>

#include "core/base/JobControl.h"
#include "core/base/ParameterSpec.h"
#include "core/base/Result.h"
#include "core/geometry/PointCloud.h"

namespace vestige {

enum class NeighbourhoodFilter { none, mean, median, gaussian };

struct NeighbourhoodOptions {
    NeighbourhoodFilter filter = NeighbourhoodFilter::gaussian;
    double radius = 0;  ///< in the cloud's unit; 0: chosen as 3 times the median local spacing
};

/// Each point replaced by a statistic of its neighbours within `radius`, itself included (METHOD section 2):
/// mean, component-wise median, or mean weighted by exp(-d^2 / (2 (radius/2)^2)). Attributes and order stay.
/// ErrorCode::usage for a radius outside Spacing.h's bounds.
Result<PointCloud> filterNeighbourhood(const PointCloud& cloud, const NeighbourhoodOptions& options,
                                       const JobControl& control = {});

}  // namespace vestige
