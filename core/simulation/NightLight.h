#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/geometry/PointCloud.h"
#include "core/simulation/Material.h"

namespace vestige {

/// How bright the street lamps and the sky make a place at night: 1 under a lamp 10 m high, 0.02 from the sky
/// alone. Shadows are left out.
double nightLight(const std::vector<Eigen::Vector3d>& lamps, const Eigen::Vector3d& place,
                  const Eigen::Vector3d& normal);

/// The colour that a photograph of the place holds, gamma encoded and dark. `light` as from nightLight.
Color nightColor(const Optics& optics, double light);

}  // namespace vestige
