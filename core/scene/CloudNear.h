#pragma once

#include <vector>

#include "core/measurement/kinds/KindInput.h"
#include "core/scene/Scene.h"

namespace vestige {

/// Points of the layer over the box in plan that the ends span, widened by `margin_m`, in scene metres. At
/// most about 100 000 of them, taken evenly; the order does not depend on threads. Empty while nothing is
/// loaded.
std::vector<Eigen::Vector3d> cloudNear(const Layer& layer, const std::vector<KindEnd>& ends, double margin_m);

}  // namespace vestige
