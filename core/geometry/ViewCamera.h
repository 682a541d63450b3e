#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/Result.h"
#include "core/geometry/BoundingBox.h"

namespace vestige {

/// A point of a picture: pixels right and down from its top left corner (pixel centres at .5), and the
/// distance along the view direction in metres.
struct PixelPoint {
    Eigen::Vector2d pixel;
    double depth_m = 0;
};

struct ViewRay {
    Eigen::Vector3d from;       ///< world
    Eigen::Vector3d direction;  ///< unit length, world
};

/// How a picture of the scene is taken; world coordinates in metres. The window, the pictures, picking and
/// the simulator use this one projection.
struct ViewCamera {
    Eigen::Vector3d position = {0, 0, 1};
    Eigen::Vector3d focalPoint = {0, 0, 0};
    Eigen::Vector3d viewUp = {0, 1, 0};
    bool parallel = false;
    double verticalAngle_rad = 0.5235987755982988;  ///< full vertical field of view, perspective only
    double halfHeight_m = 1;  ///< half of the height that fits the picture, parallel only
    int width_px = 1400;
    int height_px = 900;

    /// Nothing for a point behind a perspective camera.
    std::optional<PixelPoint> project(const Eigen::Vector3d& world) const;
    ViewRay ray(const Eigen::Vector2d& pixel) const;
    /// Metres that one pixel covers at that depth.
    double metresPerPixel(double depth_m) const;
    Eigen::Vector3d direction() const { return (focalPoint - position).normalized(); }
};

enum class NamedView { perspective, top, front, left, iso, back, right, bottom };

std::string_view name(NamedView view);
std::optional<NamedView> namedViewFromName(std::string_view name);

/// A camera of the named direction that holds the whole box. All but `perspective` and `iso` are parallel; z
/// is up, from above y, from below -y, so that x runs to the right in both.
ViewCamera fitCamera(const BoundingBox& box, NamedView view, int width_px, int height_px);

}  // namespace vestige
