#include "core/pipeline/SnapPick.h"

#include <utility>

#include "core/pipeline/LoadLayers.h"
#include "core/scene/MeasuredScene.h"

namespace vestige {

Result<FittedFeature> snapPick(const Layer& layer, const Eigen::Vector3d& world_m,
                               const Eigen::Vector3d& view, SnapMode mode, const ScannerPath* path,
                               ClipRegion clips) {
    if (!layer.data || !layer.data->octree)
        return fail(ErrorCode::input, "the layer is not loaded", layer.name);
    if (!pointsErrApart(layer.role))
        return fail(ErrorCode::input, "points of photogrammetry err together, which no fit averages out",
                    layer.name);
    SnapRequest request;
    request.octree = layer.data->octree.get();
    request.sceneFromLayer = sceneFromLayer(layer);
    request.seed = world_m;
    request.viewDirection = view;
    request.sensorNoise_m = sensorNoise_m(layer.role);
    const SensorSpot spot = sensorSpot(layer.role);
    request.path = path;
    request.spotUpright_rad = spot.upright_rad;
    request.spotLevel_rad = spot.level_rad;
    request.clips = std::move(clips);
    return snapFeature(request, mode);
}

std::optional<ScannerPath> scannerPathOf(const Layer& layer, const JobControl& control) {
    if (layer.role != LayerRole::aerial || !layer.data) return std::nullopt;
    const auto cloud = allAttributes(layer, layer.path, control);
    return cloud ? ScannerPath::recovered(**cloud) : std::nullopt;
}

}  // namespace vestige
