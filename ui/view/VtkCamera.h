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

/// A part of a picture: pixels from its top left corner. It may reach beyond the picture.
struct PictureTile {
    int left = 0;
    int top = 0;
    int width = 0;
    int height = 0;
};

/// Sets a VTK camera so that it projects as `camera` does, positions relative to `displayOrigin`, with
/// clipping planes that hold `range`.
void setVtkCamera(vtkCamera& target, const ViewCamera& camera, const Eigen::Vector3d& displayOrigin,
                  const DepthRange& range);

/// The same for a window that shows only a part of the camera's picture.
void setVtkCamera(vtkCamera& target, const ViewCamera& camera, const Eigen::Vector3d& displayOrigin,
                  const DepthRange& range, const PictureTile& tile);

/// The ViewCamera that projects as a VTK camera does in a picture of that size.
ViewCamera viewCameraOf(vtkCamera& source, const Eigen::Vector3d& displayOrigin, int width_px, int height_px);

}  // namespace vestige
