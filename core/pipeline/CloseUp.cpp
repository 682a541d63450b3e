#include "core/pipeline/CloseUp.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <span>

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

/// Slanting down by the given angles from all sides, the sides square to `along` first.
std::vector<Eigen::Vector3d> ring(const Eigen::Vector3d& along, std::initializer_list<double> downs_deg) {
    std::vector<Eigen::Vector3d> directions;
    for (const double down : downs_deg)
        for (int k = 0; k < 12; ++k) {
            const double azimuth = radians(30.0 * k);
            directions.emplace_back(std::cos(azimuth) * std::cos(radians(down)),
                                    std::sin(azimuth) * std::cos(radians(down)), -std::sin(radians(down)));
        }
    const Eigen::Vector3d unit = along.normalized();
    std::stable_sort(directions.begin(), directions.end(),
                     [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
                         return std::abs(a.dot(unit)) < std::abs(b.dot(unit)) - 1e-9;
                     });
    return directions;
}

std::size_t pointsSeen(std::span<const PickLayer> layers, const ViewCamera& camera,
                       std::span<const Eigen::Vector3d> points) {
    std::size_t seen = 0;
    for (const Eigen::Vector3d& point : points) {
        const auto pixel = camera.project(point);
        const auto pick = pixel ? pickPoint(layers, camera, pixel->pixel) : std::nullopt;
        if (!pick) continue;
        // As far off as the picking itself may be, and the scatter of the repeats.
        const double tolerance = 10 * camera.metresPerPixel(pixel->depth_m) + 3 * pick->localSpacing_m;
        if ((pick->world - point).norm() <= tolerance) ++seen;
    }
    return seen;
}

/// The first of the directions from which picking in the named layers finds most of the points.
Eigen::Vector3d bestDirection(const ViewDescription& view, const std::vector<std::string>& ids,
                              const std::vector<Eigen::Vector3d>& candidates,
                              std::span<const Eigen::Vector3d> points, const CloseUpSphere& sphere) {
    std::vector<std::shared_ptr<const Octree>> octrees;  // the layers point at them
    std::vector<PickLayer> layers;
    for (const ViewLayer& shown : view.layers) {
        if (std::find(ids.begin(), ids.end(), shown.id) == ids.end()) continue;
        const std::shared_ptr<const PointCloud> cloud(shown.geometry, &shown.geometry->vertices);
        const bool usable = shown.octree && &shown.octree->cloud() == cloud.get();
        octrees.push_back(usable ? shown.octree : std::make_shared<const Octree>(cloud));
        layers.push_back(
            {static_cast<std::uint32_t>(layers.size()), octrees.back().get(), shown.worldFromLayer});
    }
    Eigen::Vector3d best = candidates.front();
    std::size_t most = 0;
    for (const Eigen::Vector3d& direction : candidates) {
        const ViewCamera camera = cameraAround(sphere.centre, sphere.radius_m, direction);
        const std::size_t seen = pointsSeen(layers, camera, points);
        if (seen <= most) continue;
        best = direction;
        most = seen;
        if (most == points.size()) break;
    }
    return best;
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
    auto candidates = aimedDirections(scene, length);
    const auto others = ring(mark.b - mark.a, {25.0, 50.0, 85.0});
    candidates.insert(candidates.end(), others.begin(), others.end());
    const CloseUpSphere sphere{0.5 * (mark.a + mark.b), 0.6 * (mark.b - mark.a).norm() + 0.05};
    const Eigen::Vector3d ends[] = {mark.a, mark.b};
    return bestDirection(view, length.layers, candidates, ends, sphere);
}

CloseUpSphere sphereRound(const std::vector<Eigen::Vector3d>& points) {
    BoundingBox box;
    for (const Eigen::Vector3d& point : points) box.add(point);
    CloseUpSphere sphere{box.centre(), 0};
    for (const Eigen::Vector3d& point : points)
        sphere.radius_m = std::max(sphere.radius_m, (point - sphere.centre).norm());
    sphere.radius_m = 1.3 * sphere.radius_m + 0.05;
    return sphere;
}

Eigen::Vector3d closeUpDirection(const ViewDescription& view, const std::vector<std::string>& layers,
                                 const std::vector<Eigen::Vector3d>& points) {
    constexpr std::size_t kAsked = 12;
    constexpr double kLevel = 0.2;
    const CloseUpSphere sphere = sphereRound(points);
    Eigen::Vector3d along = Eigen::Vector3d::Zero();
    double lowest = points.front().z(), highest = lowest;
    for (const Eigen::Vector3d& point : points) {
        if ((point - points.front()).norm() > along.norm()) along = point - points.front();
        lowest = std::min(lowest, point.z());
        highest = std::max(highest, point.z());
    }
    const bool level = highest - lowest < kLevel * sphere.radius_m;
    std::vector<Eigen::Vector3d> asked;
    for (std::size_t i = 0; i < points.size(); i += points.size() / kAsked + 1) asked.push_back(points[i]);
    if (!(along.norm() > 0)) along = Eigen::Vector3d::UnitX();
    const auto candidates = level ? ring(along, {50.0, 85.0, 25.0}) : ring(along, {25.0, 50.0, 85.0});
    return bestDirection(view, layers, candidates, asked, sphere);
}

}  // namespace vestige
