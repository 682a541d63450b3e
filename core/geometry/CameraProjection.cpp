#include "core/geometry/CameraProjection.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace vestige {

ViewCamera withProjection(const ViewCamera& camera, bool parallel) {
    ViewCamera result = camera;
    if (camera.parallel == parallel) return result;
    result.parallel = parallel;
    const double tangent = std::tan(0.5 * camera.verticalAngle_rad);
    const double distance = (camera.focalPoint - camera.position).norm();
    if (parallel)
        result.halfHeight_m = distance * tangent;
    else
        result.position = camera.focalPoint - camera.halfHeight_m / tangent * camera.direction();
    return result;
}

ViewCamera withRoomAbove(const ViewCamera& camera, int strip_px) {
    ViewCamera result = camera;
    result.height_px += strip_px;
    const double grown = static_cast<double>(result.height_px) / camera.height_px;
    const double distance = (camera.focalPoint - camera.position).norm();
    const Eigen::Vector3d forward = camera.direction();
    const Eigen::Vector3d up = forward.cross(camera.viewUp).normalized().cross(forward);
    result.halfHeight_m *= grown;
    if (!camera.parallel) result.position = camera.focalPoint - grown * distance * forward;
    const Eigen::Vector3d shift = 0.5 * strip_px * camera.metresPerPixel(distance) * up;
    result.position += shift;
    result.focalPoint += shift;
    return result;
}

ViewCamera resized(const ViewCamera& camera, int width_px, int height_px) {
    ViewCamera result = camera;
    result.width_px = width_px;
    result.height_px = height_px;
    const double before = static_cast<double>(camera.width_px) / camera.height_px;
    const double after = static_cast<double>(width_px) / height_px;
    const double taller = std::max(1.0, before / after);
    result.halfHeight_m = camera.halfHeight_m * taller;
    result.verticalAngle_rad = 2 * std::atan(std::tan(0.5 * camera.verticalAngle_rad) * taller);
    return result;
}

}  // namespace vestige
