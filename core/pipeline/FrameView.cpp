#include "core/pipeline/FrameView.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/Random.h"
#include "core/geometry/SectionSlab.h"

namespace vestige {
namespace {

constexpr std::size_t kSample = 20000;
constexpr double kStray = 0.002;
constexpr double kFilled = 0.92;
constexpr int kSteps = 20;
constexpr double kNear = 20;  // times the sizes of both

bool isShown(const ViewLayer& layer) {
    return isDrawn(layer) && layer.geometry && !layer.geometry->vertices.empty();
}

BoundingBox boxOf(const ViewLayer& layer) {
    return layer.geometry->vertices.bounds().transformed(layer.worldFromLayer);
}

/// Of each run of points one, by chance: clouds lie in rows in their files, of which every k-th point could
/// be one column alone.
std::vector<Eigen::Vector3d> samplePoints(const ViewDescription& view) {
    std::vector<Eigen::Vector3d> sample;
    for (const std::size_t index : subjectLayers(view)) {
        const ViewLayer& layer = view.layers[index];
        const PointCloud& cloud = layer.geometry->vertices;
        const std::size_t stride = std::max<std::size_t>(1, cloud.size() / kSample);
        Random random(kSample, index);
        for (std::size_t begin = 0; begin < cloud.size(); begin += stride) {
            const std::size_t run = std::min(stride, cloud.size() - begin);
            const Eigen::Vector3d point = layer.worldFromLayer * cloud.point(begin + random.below(run));
            if (!view.section || view.section->keeps(point)) sample.push_back(point);
        }
    }
    return sample;
}

struct Extent {
    double low;
    double high;
};

/// The value that `rank` others come before: few, so that the first of them are kept as a heap.
template <class Before>
double ranked(const std::vector<double>& values, std::size_t rank, const Before& before) {
    std::vector<double> first(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rank) + 1);
    std::make_heap(first.begin(), first.end(), before);
    for (std::size_t i = rank + 1; i < values.size(); ++i) {
        if (!before(values[i], first.front())) continue;
        std::pop_heap(first.begin(), first.end(), before);
        first.back() = values[i];
        std::push_heap(first.begin(), first.end(), before);
    }
    return first.front();
}

/// Of all but the stray values; not for none.
Extent extentOf(const std::vector<double>& values) {
    const auto drop = static_cast<std::size_t>(kStray * static_cast<double>(values.size()));
    return {ranked(values, drop, std::less<>()), ranked(values, drop, std::greater<>())};
}

/// ViewCamera::project for many points of one camera: to the last bit the same.
class Projection {
  public:
    explicit Projection(const ViewCamera& camera)
        : camera_(camera),
          forward_(camera.direction()),
          right_(forward_.cross(camera.viewUp).normalized()),
          up_(right_.cross(forward_)),
          tangent_(std::tan(0.5 * camera.verticalAngle_rad)) {}
    std::optional<Eigen::Vector2d> operator()(const Eigen::Vector3d& world) const {
        const Eigen::Vector3d ray = world - camera_.position;
        const double depth = ray.dot(forward_);
        if (!camera_.parallel && depth <= 0) return std::nullopt;
        const double halfHeight = camera_.parallel ? camera_.halfHeight_m : depth * tangent_;
        const double scale = 1 / (2 * halfHeight / camera_.height_px);
        return Eigen::Vector2d(0.5 * camera_.width_px + scale * ray.dot(right_),
                               0.5 * camera_.height_px - scale * ray.dot(up_));
    }

  private:
    const ViewCamera& camera_;
    Eigen::Vector3d forward_;
    Eigen::Vector3d right_;
    Eigen::Vector3d up_;
    double tangent_;
};

/// The box of all but the stray points on each axis.
BoundingBox boxOf(const std::vector<Eigen::Vector3d>& sample) {
    BoundingBox box;
    if (sample.empty()) return box;
    std::vector<double> values(sample.size());
    for (int axis = 0; axis < 3; ++axis) {
        std::transform(sample.begin(), sample.end(), values.begin(),
                       [axis](const Eigen::Vector3d& point) { return point[axis]; });
        const Extent extent = extentOf(values);
        box.min[axis] = extent.low;
        box.max[axis] = extent.high;
    }
    return box;
}

}  // namespace

std::vector<std::size_t> subjectLayers(const ViewDescription& view) {
    std::optional<std::size_t> anchor;
    for (std::size_t i = 0; i < view.layers.size(); ++i)
        if (isShown(view.layers[i]) && (!anchor || view.layers[i].isTarget)) anchor = i;
    if (!anchor) return {};
    const BoundingBox scene = boxOf(view.layers[*anchor]);
    std::vector<std::size_t> subject;
    for (std::size_t i = 0; i < view.layers.size(); ++i) {
        if (!isShown(view.layers[i])) continue;
        const BoundingBox box = boxOf(view.layers[i]);
        const double apart = (box.centre() - scene.centre()).norm();
        if (apart <= kNear * (box.diagonal() + scene.diagonal())) subject.push_back(i);
    }
    return subject;
}

BoundingBox subjectBounds(const ViewDescription& view) {
    BoundingBox box;
    for (const std::size_t index : subjectLayers(view)) box.add(boxOf(view.layers[index]));
    return box;
}

namespace {

/// The camera moved, and brought nearer, until the points fill its picture.
ViewCamera filled(ViewCamera camera, const std::vector<Eigen::Vector3d>& sample) {
    const int width_px = camera.width_px;
    const int height_px = camera.height_px;
    const Eigen::Vector3d forward = camera.direction();
    const Eigen::Vector3d right = forward.cross(camera.viewUp).normalized();
    const Eigen::Vector3d up = right.cross(forward);
    std::vector<double> across;
    std::vector<double> down;
    for (int step = 0; step < kSteps; ++step) {
        across.clear();
        down.clear();
        const Projection project(camera);
        for (const Eigen::Vector3d& point : sample) {
            const auto seen = project(point);
            if (!seen) continue;
            across.push_back(seen->x());
            down.push_back(seen->y());
        }
        if (across.empty()) return camera;
        const Extent x = extentOf(across);
        const Extent y = extentOf(down);
        const double filled = std::max((x.high - x.low) / width_px, (y.high - y.low) / height_px);
        if (filled < 1e-6) return camera;
        const double distance = (camera.focalPoint - camera.position).norm();
        const double metres = camera.metresPerPixel(distance);
        const Eigen::Vector3d shift =
            metres * (0.5 * (x.low + x.high - width_px) * right - 0.5 * (y.low + y.high - height_px) * up);
        // In small steps, so that no point passes behind the camera before its growth is seen.
        const double factor = std::clamp(filled / kFilled, 0.6, 1.6);
        camera.focalPoint += shift;
        camera.position += shift;
        if (camera.parallel)
            camera.halfHeight_m *= factor;
        else
            camera.position = camera.focalPoint - factor * distance * forward;
    }
    return camera;
}

/// All of a section, where a sample has hardly a point in it.
BoundingBox boxOf(const ViewDescription& view, const std::vector<Eigen::Vector3d>& sample) {
    constexpr std::size_t kFew = 50;
    BoundingBox box = boxOf(sample);
    if (box.empty() && view.section && view.section->inverted) return subjectBounds(view);
    if (!view.section || view.section->inverted || sample.size() >= kFew) return box;
    const BoundingBox scene = subjectBounds(view);
    BoundingBox corners;
    for (int corner = 0; corner < 8; ++corner) {
        Eigen::Vector3d at = view.section->centre;
        for (int axis = 0; axis < 3; ++axis)
            at +=
                ((corner >> axis) & 1 ? 1 : -1) * view.section->halfSize[axis] * axisOf(*view.section, axis);
        corners.add(at);
    }
    if (scene.empty()) return corners;
    corners.min = corners.min.cwiseMax(scene.min);
    corners.max = corners.max.cwiseMin(scene.max);
    return (corners.min.array() <= corners.max.array()).all() ? corners : box;
}

}  // namespace

ViewCamera frameView(const ViewDescription& view, NamedView direction, int width_px, int height_px) {
    const std::vector<Eigen::Vector3d> sample = samplePoints(view);
    return filled(fitCamera(boxOf(view, sample), direction, width_px, height_px), sample);
}

ViewCamera framed(const ViewDescription& view, const ViewCamera& from) {
    const std::vector<Eigen::Vector3d> sample = samplePoints(view);
    const BoundingBox box = boxOf(view, sample);
    if (box.empty()) return from;
    const double reach = std::max(0.5 * box.diagonal(), 1e-3);
    const double narrow = std::min(1.0, static_cast<double>(from.width_px) / from.height_px);
    ViewCamera camera = from;
    camera.focalPoint = box.centre();
    camera.halfHeight_m = reach / narrow;
    const double distance =
        from.parallel ? 2 * reach + 1 : reach / narrow / std::tan(0.5 * from.verticalAngle_rad) + reach;
    camera.position = camera.focalPoint - distance * from.direction();
    return filled(camera, sample);
}

Eigen::Vector2d extentSeen_m(const ViewDescription& view, const ViewCamera& camera) {
    std::vector<double> across;
    std::vector<double> down;
    for (const Eigen::Vector3d& point : samplePoints(view)) {
        const auto seen = camera.project(point);
        if (!seen) continue;
        across.push_back(seen->pixel.x());
        down.push_back(seen->pixel.y());
    }
    if (across.empty()) return Eigen::Vector2d::Zero();
    const Extent x = extentOf(across);
    const Extent y = extentOf(down);
    const double metres = camera.metresPerPixel((camera.focalPoint - camera.position).norm());
    return metres * Eigen::Vector2d(x.high - x.low, y.high - y.low);
}

}  // namespace vestige
