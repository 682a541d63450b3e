#include "ui/view/VtkCamera.h"

#include <vtkCamera.h>
#include <vtkMath.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace vestige {

std::optional<DepthRange> depthsSeen(const ViewCamera& camera, const Eigen::Vector3d& min,
                                     const Eigen::Vector3d& max) {
    const Eigen::Vector3d forward = camera.direction();
    const Eigen::Vector3d right = forward.cross(camera.viewUp).normalized();
    const Eigen::Vector3d up = right.cross(forward);
    const double aspect = static_cast<double>(camera.width_px) / camera.height_px;
    const double tangent = std::tan(0.5 * camera.verticalAngle_rad);
    DepthRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    int outside[5] = {};
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d arm =
            Eigen::Vector3d((corner & 1) ? max.x() : min.x(), (corner & 2) ? max.y() : min.y(),
                            (corner & 4) ? max.z() : min.z()) -
            camera.position;
        const double depth = arm.dot(forward);
        const double halfHeight = camera.parallel ? camera.halfHeight_m : depth * tangent;
        outside[0] += arm.dot(right) > halfHeight * aspect;
        outside[1] += arm.dot(right) < -halfHeight * aspect;
        outside[2] += arm.dot(up) > halfHeight;
        outside[3] += arm.dot(up) < -halfHeight;
        outside[4] += !camera.parallel && depth <= 0;
        range.nearest = std::min(range.nearest, depth);
        range.farthest = std::max(range.farthest, depth);
    }
    if (std::any_of(std::begin(outside), std::end(outside), [](int count) { return count == 8; }))
        return std::nullopt;
    return range;
}

void setVtkCamera(vtkCamera& target, const ViewCamera& camera, const Eigen::Vector3d& displayOrigin,
                  const DepthRange& range) {
    const Eigen::Vector3d position = camera.position - displayOrigin;
    const Eigen::Vector3d focalPoint = camera.focalPoint - displayOrigin;
    target.SetPosition(position.data());
    target.SetFocalPoint(focalPoint.data());
    target.SetViewUp(camera.viewUp.data());
    target.SetParallelProjection(camera.parallel);
    target.SetParallelScale(camera.halfHeight_m);
    target.SetUseHorizontalViewAngle(0);
    target.SetViewAngle(vtkMath::DegreesFromRadians(camera.verticalAngle_rad));
    const double margin = 0.01 * (range.farthest - range.nearest) + 1e-3;
    double nearest = range.nearest - margin;
    double farthest = range.farthest + margin;
    if (!camera.parallel) {
        // Depths are drawn as 32-bit floats of 1/depth: with this ratio two surfaces 1 % of their distance
        // apart stay apart everywhere.
        farthest = std::max(farthest, 0.01);
        nearest = std::max(nearest, 3e-5 * farthest);
    }
    target.SetClippingRange(nearest, farthest);
    target.SetWindowCenter(0, 0);
}

void setVtkCamera(vtkCamera& target, const ViewCamera& camera, const Eigen::Vector3d& displayOrigin,
                  const DepthRange& range, const PictureTile& tile) {
    setVtkCamera(target, camera, displayOrigin, range);
    const double share = static_cast<double>(tile.height) / camera.height_px;
    target.SetParallelScale(camera.halfHeight_m * share);
    target.SetViewAngle(
        vtkMath::DegreesFromRadians(2 * std::atan(std::tan(0.5 * camera.verticalAngle_rad) * share)));
    // In halves of the part's own size, right and up.
    target.SetWindowCenter((2.0 * tile.left + tile.width - camera.width_px) / tile.width,
                           (camera.height_px - 2.0 * tile.top - tile.height) / tile.height);
}

ViewCamera viewCameraOf(vtkCamera& source, const Eigen::Vector3d& displayOrigin, int width_px,
                        int height_px) {
    ViewCamera camera;
    camera.position = displayOrigin + Eigen::Vector3d(source.GetPosition());
    camera.focalPoint = displayOrigin + Eigen::Vector3d(source.GetFocalPoint());
    camera.viewUp = Eigen::Vector3d(source.GetViewUp());
    camera.parallel = source.GetParallelProjection() != 0;
    camera.halfHeight_m = source.GetParallelScale();
    camera.verticalAngle_rad = vtkMath::RadiansFromDegrees(source.GetViewAngle());
    camera.width_px = width_px;
    camera.height_px = height_px;
    return camera;
}

}  // namespace vestige
