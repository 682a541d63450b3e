#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/geometry/ViewCamera.h"

class QPainter;

namespace vestige {

struct ViewTheme;

/// Paints the points picked so far of a path, in world coordinates, and the line through them; what lies
/// behind the camera is left out.
void paintPendingPath(QPainter& painter, const ViewTheme& theme, const ViewCamera& camera,
                      const std::vector<Eigen::Vector3d>& path);

}  // namespace vestige
