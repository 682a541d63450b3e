#include "core/geometry/SectionSlab.h"

#include <algorithm>
#include <cmath>

namespace vestige {
namespace {

constexpr double kThinnest_m = 1e-3;
/// Looking down more steeply than this a slab along the view lies level.
constexpr double kSteep = 0.8;

BoundingBox orUnit(const BoundingBox& scene) {
    return scene.empty() ? BoundingBox{{-1, -1, -1}, {1, 1, 1}} : scene;
}

}  // namespace

Eigen::Vector3d axisOf(const SectionBox& box, int axis) {
    const double c = std::cos(box.heading_rad);
    const double s = std::sin(box.heading_rad);
    if (axis == 0) return {c, s, 0};
    if (axis == 1) return {-s, c, 0};
    return {0, 0, 1};
}

SectionBox sectionRound(const BoundingBox& scene) {
    const BoundingBox box = orUnit(scene);
    SectionBox section;
    section.centre = box.centre();
    section.halfSize = (0.505 * (box.max - box.min)).array().max(0.05);
    return section;
}

SectionBox slab(const BoundingBox& scene, SlabAxis axis, double thickness_m, const ViewCamera& camera) {
    SectionBox section = sectionRound(scene);
    const double half = std::max(kThinnest_m, 0.5 * thickness_m);
    const Eigen::Vector3d forward = camera.direction();
    if (axis == SlabAxis::view && std::abs(forward.z()) > kSteep) axis = SlabAxis::z;
    if (axis == SlabAxis::view) {
        section.heading_rad = std::atan2(forward.y(), forward.x());
        const double reach = section.halfSize.head<2>().norm();
        section.halfSize = {half, reach, section.halfSize.z()};
        return section;
    }
    section.halfSize[static_cast<int>(axis)] = half;
    return section;
}

int thinAxis(const SectionBox& box) {
    int axis = 0;
    box.halfSize.minCoeff(&axis);
    return axis;
}

SectionBox moved(const SectionBox& box, int axis, double by_m) {
    SectionBox result = box;
    result.centre += by_m * axisOf(box, axis);
    return result;
}

SectionBox withFaceMoved(const SectionBox& box, int axis, int side, double by_m) {
    SectionBox result = box;
    const double half = std::max(0.5 * kThinnest_m, box.halfSize[axis] + 0.5 * by_m);
    result.centre += side * (half - box.halfSize[axis]) * axisOf(box, axis);
    result.halfSize[axis] = half;
    return result;
}

}  // namespace vestige
