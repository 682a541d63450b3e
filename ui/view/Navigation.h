#pragma once

#include "core/geometry/ViewCamera.h"

namespace vestige {

/// How the mouse moves the camera: functions of the camera alone. Pixels are those of the camera's picture.

/// Turns the view round `pivot` (world), which keeps its place in the picture; z stays up. A drag to the
/// right turns the scene to the right, a drag down tips its top towards the viewer, at most until it is seen
/// from straight above or below.
ViewCamera orbited(const ViewCamera& camera, const Eigen::Vector3d& pivot, const Eigen::Vector2d& drag_px);

/// Shifts the view so that what lies at `depth_m` under the cursor stays under it.
ViewCamera panned(const ViewCamera& camera, double depth_m, const Eigen::Vector2d& drag_px);

/// Brings the view nearer to `pivot` (world), which keeps its place in the picture: distances to it are
/// multiplied by `factor`.
ViewCamera zoomed(const ViewCamera& camera, const Eigen::Vector3d& pivot, double factor);

/// The camera with its focal point at that depth; the picture is the same.
ViewCamera focusedAt(const ViewCamera& camera, double depth_m);

}  // namespace vestige
