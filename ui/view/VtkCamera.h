#pragma once

#include <Eigen/Core>

#include "core/geometry/ViewCamera.h"

class vtkCamera;

namespace vestige {

/// Depths along the view direction, metres.
struct DepthRange {
    double nearest;
    double farthest;
};

/// Where a box (world) lies in depth; nothing when it is certainly outside the picture.
std::optional<DepthRange> depthsSeen(const ViewCamera& camera, const Eigen::Vector3d& min,
                                     const Eigen::Vector3d& max);

/// Sets a VTK camera so that it projects as `camera` does, positions relative to `displayOrigin`, with
/// clipping planes that hold `range`.
void setVtkCamera(vtkCamera& target, const ViewCamera& camera, const Eigen::Vector3d& displayOrigin,
                  const DepthRange& range);

/// The ViewCamera that projects as a VTK camera does in a picture of that size.
ViewCamera viewCameraOf(vtkCamera& source, const Eigen::Vector3d& displayOrigin, int width_px, int height_px);

}  // namespace vestige
