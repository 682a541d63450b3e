#include "core/pipeline/CloseUp.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "core/geometry/Picking.h"
#include "core/scene/PickFrame.h"

namespace vestige {
namespace {

/// The directions of the aims that the length was measured with.
std::vector<Eigen::Vector3d> aimedDirections(const SceneState& scene, const MeasuredLength& length) {
    std::vector<Eigen::Vector3d> directions;
    const Measurement* measurement = scene.measurement(length.object);
    const auto aims =
        measurement ? measurement->aims.find(length.method) : decltype(measurement->aims.end()){};
    if (!measurement || aims == measurement->aims.end()) return directions;
    for (const AimedPair& pair : aims->second)
        if (const auto camera = cameraInScene(scene, pair.a.view)) directions.push_back(camera->direction());
    return directions;
}

/// Slanting down by 25 and 50 degrees from all sides, the sides square to the pair first.
std::vector<Eigen::Vector3d> ring(const ViewMark& mark) {
    std::vector<Eigen::Vector3d> directions;
    for (const double down : {25.0, 50.0, 85.0})
        for (int k = 0; k < 12; ++k) {
            const double azimuth = radians(30.0 * k);
            directions.emplace_back(std::cos(azimuth) * std::cos(radians(down)),
                                    std::sin(azimuth) * std::cos(radians(down)), -std::sin(radians(down)));
        }
    const Eigen::Vector3d along = (mark.b - mark.a).normalized();
    std::stable_sort(directions.begin(), directions.end(),
                     [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
                         return std::abs(a.dot(along)) < std::abs(b.dot(along)) - 1e-9;
                     });
    return directions;
}

int endsSeen(std::span<const PickLayer> layers, const ViewCamera& camera, const ViewMark& mark) {
    int seen = 0;
    for (const Eigen::Vector3d& end : {mark.a, mark.b}) {
        const auto pixel = camera.project(end);
        const auto pick = pixel ? pickPoint(layers, camera, pixel->pixel) : std::nullopt;
        if (!pick) continue;
        // As far off as the picking itself may be, and the scatter of the repeats.
        const double tolerance = 10 * camera.metresPerPixel(pixel->depth_m) + 3 * pick->localSpacing_m;
        if ((pick->world - end).norm() <= tolerance) ++seen;
    }
    return seen;
}

}  // namespace

bool cropView(ViewDescription& view, const SceneState& scene, const Eigen::Vector3d& centre, double radius_m,
              double ceiling_m) {
    std::vector<Octree::Neighbour> found;
    std::vector<std::uint32_t> kept;
    bool leftOut = false;
    for (ViewLayer& shown : view.layers) {
        const Layer* layer = scene.layer(shown.id);
        if (!layer || !layer->data || !layer->data->octree || shown.geometry->isMesh()) continue;
        const PointCloud& cloud = *layer->data->points;
        const Eigen::Vector3d offset = shown.worldFromLayer.inverse() * centre - cloud.origin();
        layer->data->octree->radiusSearch(offset.cast<float>(),
                                          static_cast<float>(radius_m / shown.worldFromLayer.scale), found);
        kept.clear();
        for (const auto& neighbour : found)
            if ((shown.worldFromLayer * cloud.point(neighbour.point)).z() <= ceiling_m)
                kept.push_back(neighbour.point);
        leftOut = leftOut || kept.size() < found.size();
        shown.geometry = std::make_shared<const TriangleMesh>(TriangleMesh{cloud.select(kept), {}});
        // Here, not where it is drawn: that is the thread of the window.
        shown.octree = std::make_shared<const Octree>(
            std::shared_ptr<const PointCloud>(shown.geometry, &shown.geometry->vertices));
        shown.residual_m = nullptr;
    }
    std::erase_if(view.layers, [](const ViewLayer& layer) { return layer.geometry->vertices.empty(); });
    return leftOut;
}

ViewCamera cameraAround(const Eigen::Vector3d& centre, double radius_m, const Eigen::Vector3d& direction) {
    ViewCamera camera;
    camera.focalPoint = centre;
    camera.position = centre - direction.normalized() * (radius_m / std::sin(camera.verticalAngle_rad / 2));
    camera.viewUp =
        std::abs(direction.normalized().z()) > 0.98 ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
    return camera;
}

Eigen::Vector3d closeUpDirection(const ViewDescription& view, const SceneState& scene,
                                 const MeasuredLength& length, const ViewMark& mark) {
    std::vector<std::shared_ptr<const Octree>> octrees;  // the layers point at them
    std::vector<PickLayer> layers;
    for (const ViewLayer& shown : view.layers) {
        if (std::find(length.layers.begin(), length.layers.end(), shown.id) == length.layers.end()) continue;
        const std::shared_ptr<const PointCloud> cloud(shown.geometry, &shown.geometry->vertices);
        const bool usable = shown.octree && &shown.octree->cloud() == cloud.get();
        octrees.push_back(usable ? shown.octree : std::make_shared<const Octree>(cloud));
        layers.push_back(
            {static_cast<std::uint32_t>(layers.size()), octrees.back().get(), shown.worldFromLayer});
    }
    auto candidates = aimedDirections(scene, length);
    const auto others = ring(mark);
    candidates.insert(candidates.end(), others.begin(), others.end());
    const Eigen::Vector3d middle = 0.5 * (mark.a + mark.b);
    const double radius = 0.6 * (mark.b - mark.a).norm() + 0.05;
    Eigen::Vector3d best = candidates.front();
    int most = 0;
    for (const Eigen::Vector3d& direction : candidates) {
        const int seen = endsSeen(layers, cameraAround(middle, radius, direction), mark);
        if (seen <= most) continue;
        best = direction;
        most = seen;
        if (most == 2) break;
    }
    return best;
}

}  // namespace vestige
