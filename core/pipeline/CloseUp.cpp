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

bool seesBothEnds(std::span<const PickLayer> layers, const ViewCamera& camera, const ViewMark& mark) {
    for (const Eigen::Vector3d& end : {mark.a, mark.b}) {
        const auto pixel = camera.project(end);
        if (!pixel) return false;
        const auto pick = pickPoint(layers, camera, pixel->pixel);
        if (!pick) return false;
        // As far off as the picking itself may be, and the scatter of the repeats.
        const double tolerance = 10 * camera.metresPerPixel(pixel->depth_m) + 3 * pick->localSpacing_m;
        if ((pick->world - end).norm() > tolerance) return false;
    }
    return true;
}

}  // namespace

void cropView(ViewDescription& view, const SceneState& scene, const Eigen::Vector3d& centre,
              double radius_m) {
    std::vector<Octree::Neighbour> found;
    std::vector<std::uint32_t> kept;
    for (ViewLayer& shown : view.layers) {
        const Layer* layer = scene.layer(shown.id);
        if (!layer || !layer->data || !layer->data->octree || shown.geometry->isMesh()) continue;
        const PointCloud& cloud = *layer->data->points;
        const Eigen::Vector3d offset = shown.worldFromLayer.inverse() * centre - cloud.origin();
        layer->data->octree->radiusSearch(offset.cast<float>(),
                                          static_cast<float>(radius_m / shown.worldFromLayer.scale), found);
        kept.clear();
        for (const auto& neighbour : found) kept.push_back(neighbour.point);
        shown.geometry = std::make_shared<const TriangleMesh>(TriangleMesh{cloud.select(kept), {}});
        shown.residual_m = nullptr;
    }
    std::erase_if(view.layers, [](const ViewLayer& layer) { return layer.geometry->vertices.empty(); });
}

ViewCamera cameraAround(const Eigen::Vector3d& centre, double radius_m, const Eigen::Vector3d& direction) {
    ViewCamera camera;
    camera.focalPoint = centre;
    camera.position = centre - direction.normalized() * (radius_m / std::sin(camera.verticalAngle_rad / 2));
    camera.viewUp =
        std::abs(direction.normalized().z()) > 0.98 ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
    return camera;
}

Eigen::Vector3d closeUpDirection(const SceneState& scene, const MeasuredLength& length,
                                 const ViewMark& mark) {
    std::vector<PickLayer> layers;
    for (std::size_t i = 0; i < scene.layers.size(); ++i) {
        const Layer& layer = scene.layers[i];
        const bool measured =
            std::find(length.layers.begin(), length.layers.end(), layer.id) != length.layers.end();
        if (measured && layer.data)
            layers.push_back(
                {static_cast<std::uint32_t>(i), layer.data->octree.get(), sceneFromLayer(layer)});
    }
    auto candidates = aimedDirections(scene, length);
    const auto others = ring(mark);
    candidates.insert(candidates.end(), others.begin(), others.end());
    const Eigen::Vector3d middle = 0.5 * (mark.a + mark.b);
    const double radius = 0.6 * (mark.b - mark.a).norm() + 0.05;
    for (const Eigen::Vector3d& direction : candidates)
        if (seesBothEnds(layers, cameraAround(middle, radius, direction), mark)) return direction;
    return candidates.front();
}

}  // namespace vestige
