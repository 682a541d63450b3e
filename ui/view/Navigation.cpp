#include "ui/view/Navigation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace vestige {
namespace {

constexpr double kRadiansPerPixel = 0.007;
constexpr double kQuarterTurn = 1.5707963267948966;
constexpr double kNearest_m = 0.01;

ViewCamera turned(const ViewCamera& camera, const Eigen::Vector3d& pivot, const Eigen::Matrix3d& rotation) {
    ViewCamera result = camera;
    result.position = pivot + rotation * (camera.position - pivot);
    result.focalPoint = pivot + rotation * (camera.focalPoint - pivot);
    result.viewUp = (rotation * camera.viewUp).normalized();
    return result;
}

Eigen::Vector3d right(const ViewCamera& camera) {
    return camera.direction().cross(camera.viewUp).normalized();
}

ViewCamera shifted(const ViewCamera& camera, const Eigen::Vector3d& by) {
    ViewCamera result = camera;
    result.position += by;
    result.focalPoint += by;
    return result;
}

}  // namespace

ViewCamera orbited(const ViewCamera& camera, const Eigen::Vector3d& pivot, const Eigen::Vector2d& drag_px) {
    ViewCamera upright = camera;
    upright.viewUp = right(camera).cross(camera.direction());
    const double elevation = std::asin(std::clamp(camera.direction().z(), -1.0, 1.0));
    const double tilt =
        std::clamp(elevation - kRadiansPerPixel * drag_px.y(), -kQuarterTurn, kQuarterTurn) - elevation;
    const Eigen::AngleAxisd pitch(tilt, right(camera));
    const Eigen::AngleAxisd yaw(-kRadiansPerPixel * drag_px.x(), Eigen::Vector3d::UnitZ());
    return turned(upright, pivot, (yaw * pitch).toRotationMatrix());
}

ViewCamera panned(const ViewCamera& camera, double depth_m, const Eigen::Vector2d& drag_px) {
    const double metres = camera.metresPerPixel(depth_m);
    const Eigen::Vector3d up = right(camera).cross(camera.direction());
    return shifted(camera, metres * (drag_px.y() * up - drag_px.x() * right(camera)));
}

ViewCamera zoomed(const ViewCamera& camera, const Eigen::Vector3d& pivot, double factor) {
    if (!camera.parallel) {
        const Eigen::Vector3d arm = pivot - camera.position;
        const double depth = arm.dot(camera.direction());
        if (factor * depth < kNearest_m) return camera;
        return focusedAt(shifted(camera, (1 - factor) * arm), factor * depth);
    }
    const Eigen::Vector3d arm = pivot - camera.position;
    const Eigen::Vector3d aside = arm - arm.dot(camera.direction()) * camera.direction();
    ViewCamera result = shifted(camera, (1 - factor) * aside);
    result.halfHeight_m = std::max(1e-4, factor * camera.halfHeight_m);
    return result;
}

ViewCamera focusedAt(const ViewCamera& camera, double depth_m) {
    ViewCamera result = camera;
    if (depth_m > kNearest_m) result.focalPoint = camera.position + depth_m * camera.direction();
    return result;
}

}  // namespace vestige
