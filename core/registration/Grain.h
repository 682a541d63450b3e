#pragma once

#include "core/geometry/PointCloud.h"

namespace vestige {

/// How finely a cloud shows its surface, metres.
struct Grain {
    double spacing_m = 0;    ///< mean, of points on the surface
    double thickness_m = 0;  ///< how thick the flattest quarter of it is: noise
};

/// Of a cloud whose unit is `scale` metres; the thickness in cells of `cell_m`. Zeroes for a cloud without
/// extent.
Grain grainOf(const PointCloud& cloud, double scale, double cell_m);

}  // namespace vestige
