#include "core/geometry/ViewCamera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vestige {
namespace {

struct Axes {
    Eigen::Vector3d right;
    Eigen::Vector3d up;
    Eigen::Vector3d forward;
};

Axes axes(const ViewCamera& camera) {
    const Eigen::Vector3d forward = camera.direction();
    const Eigen::Vector3d right = forward.cross(camera.viewUp).normalized();
    return {right, right.cross(forward), forward};
}

constexpr std::array<std::pair<NamedView, std::string_view>, 8> kNames{
    {{NamedView::perspective, "perspective"},
     {NamedView::top, "top"},
     {NamedView::front, "front"},
     {NamedView::left, "left"},
     {NamedView::iso, "iso"},
     {NamedView::back, "back"},
     {NamedView::right, "right"},
     {NamedView::bottom, "bottom"}}};

Eigen::Vector3d viewDirection(NamedView view) {
    switch (view) {
        case NamedView::top:
            return {0, 0, -1};
        case NamedView::front:
            return {0, 1, 0};
        case NamedView::left:
            return {1, 0, 0};
        case NamedView::back:
            return {0, -1, 0};
        case NamedView::right:
            return {-1, 0, 0};
        case NamedView::bottom:
            return {0, 0, 1};
        case NamedView::iso:
            return Eigen::Vector3d(-1, 1, -1).normalized();
        case NamedView::perspective:
            break;
    }
    return Eigen::Vector3d(-0.45, 0.75, -0.5).normalized();
}

Eigen::Vector3d viewUp(NamedView view) {
    if (view == NamedView::top) return Eigen::Vector3d::UnitY();
    if (view == NamedView::bottom) return -Eigen::Vector3d::UnitY();
    return Eigen::Vector3d::UnitZ();
}

}  // namespace

std::optional<PixelPoint> ViewCamera::project(const Eigen::Vector3d& world) const {
    const Axes view = axes(*this);
    const Eigen::Vector3d ray = world - position;
    const double depth = ray.dot(view.forward);
    if (!parallel && depth <= 0) return std::nullopt;
    const double scale = 1 / metresPerPixel(depth);
    return PixelPoint{
        {0.5 * width_px + scale * ray.dot(view.right), 0.5 * height_px - scale * ray.dot(view.up)}, depth};
}

ViewRay ViewCamera::ray(const Eigen::Vector2d& pixel) const {
    const Axes view = axes(*this);
    const double atUnitDepth = metresPerPixel(1);
    const Eigen::Vector3d aside = view.right * ((pixel.x() - 0.5 * width_px) * atUnitDepth) -
                                  view.up * ((pixel.y() - 0.5 * height_px) * atUnitDepth);
    if (parallel) return {position + aside, view.forward};
    return {position, (view.forward + aside).normalized()};
}

double ViewCamera::metresPerPixel(double depth_m) const {
    const double halfHeight = parallel ? halfHeight_m : depth_m * std::tan(0.5 * verticalAngle_rad);
    return 2 * halfHeight / height_px;
}

std::string_view name(NamedView view) {
    for (const auto& [candidate, text] : kNames)
        if (candidate == view) return text;
    return {};
}

std::optional<NamedView> namedViewFromName(std::string_view name) {
    for (const auto& [candidate, text] : kNames)
        if (text == name) return candidate;
    return std::nullopt;
}

ViewCamera fitCamera(const BoundingBox& box, NamedView view, int width_px, int height_px) {
    ViewCamera camera;
    camera.width_px = width_px;
    camera.height_px = height_px;
    camera.parallel = view != NamedView::perspective && view != NamedView::iso;
    camera.viewUp = viewUp(view);
    const BoundingBox shown = box.empty() ? BoundingBox{{-1, -1, -1}, {1, 1, 1}} : box;
    const Eigen::Vector3d forward = viewDirection(view);
    const Eigen::Vector3d right = forward.cross(camera.viewUp).normalized();
    const Eigen::Vector3d up = right.cross(forward);
    const double aspect = static_cast<double>(width_px) / height_px;
    const double tangent = std::tan(0.5 * camera.verticalAngle_rad);
    const double margin = 1.04;
    double halfHeight = 1e-3;
    double distance = 1e-3;
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d arm((corner & 1) ? shown.max.x() : shown.min.x(),
                                  (corner & 2) ? shown.max.y() : shown.min.y(),
                                  (corner & 4) ? shown.max.z() : shown.min.z());
        const Eigen::Vector3d fromCentre = arm - shown.centre();
        const double needed =
            margin * std::max(std::abs(fromCentre.dot(up)), std::abs(fromCentre.dot(right)) / aspect);
        halfHeight = std::max(halfHeight, needed);
        distance = std::max(distance, needed / tangent - fromCentre.dot(forward));
    }
    camera.halfHeight_m = halfHeight;
    camera.focalPoint = shown.centre();
    if (camera.parallel) distance = shown.diagonal() + 1;
    camera.position = camera.focalPoint - distance * forward;
    return camera;
}

}  // namespace vestige
