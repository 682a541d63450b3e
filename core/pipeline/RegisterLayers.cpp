#include "core/pipeline/RegisterLayers.h"

#include "core/base/Parallel.h"
#include "core/filters/Preprocess.h"
#include "core/pipeline/InitialPlacement.h"
#include "core/registration/Register.h"

namespace vestige {
namespace {

struct LayerPair {
    const Layer* target;
    const Layer* source;
};

Result<LayerPair> findPair(const SceneState& scene, const std::string& id) {
    const LayerPair pair{scene.layer(scene.target), scene.layer(id)};
    if (!pair.target)
        return fail(ErrorCode::input, "the case names no layer that the others are registered to",
                    "registration.target", "one of the layers' ids");
    if (!pair.source) return fail(ErrorCode::input, "the case has no layer of this name", "layer " + id);
    if (pair.source == pair.target)
        return fail(ErrorCode::usage, "the target cannot be registered to itself", "layer " + id);
    for (const Layer* layer : {pair.target, pair.source})
        if (!layer->data || layer->data->points->empty())
            return fail(ErrorCode::input, "the layer has no points", "layer " + layer->id);
    return pair;
}

/// The points inside the box (metres), in their order.
PointCloud cropped(const PointCloud& cloud, double metresPerUnit, const BoundingBox& box) {
    constexpr std::size_t kGrain = 1 << 16;
    std::vector<std::vector<std::uint32_t>> parts((cloud.size() + kGrain - 1) / kGrain);
    parallelChunks(cloud.size(), kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Eigen::Vector3d point = metresPerUnit * cloud.point(i);
            if ((point.array() >= box.min.array()).all() && (point.array() <= box.max.array()).all())
                parts[chunk].push_back(static_cast<std::uint32_t>(i));
        }
    });
    std::vector<std::uint32_t> kept;
    for (const auto& part : parts) kept.insert(kept.end(), part.begin(), part.end());
    return kept.size() == cloud.size() ? cloud : cloud.select(kept);
}

/// The target is thinned to no less than this share of the source's extent: the working voxel of a site (0.2
/// m) would leave no surface of a car's front to register to.
constexpr double kVoxelsPerExtent = 1.0 / 64;

double metres(const BoundingBox& sourceBounds, const Similarity& targetFromSource) {
    return targetFromSource.scale * sourceBounds.diagonal();
}

/// The target in metres, thinned and cleaned as the case says; a mesh stays as it is.
Result<TriangleMesh> preparedTarget(const SceneState& scene, const Layer& target, const Layer& source,
                                    const InitialPlacement& placement, const JobControl& control) {
    const double unit = target.metresPerUnit();
    const Similarity metresFromTarget{Pose::Identity(), unit};
    if (target.data->geometry->isMesh())
        return unit == 1 ? *target.data->geometry : target.data->geometry->transformed(metresFromTarget);
    PointCloud near = *target.data->points;
    if (placement.reach_m) {
        BoundingBox box = source.data->points->bounds().transformed(placement.targetFromSource);
        box.min.array() -= *placement.reach_m;
        box.max.array() += *placement.reach_m;
        near = cropped(near, unit, box);
        if (near.empty())
            return fail(ErrorCode::untrustworthy,
                        "the first pose puts the scan where the target has no points", "layer " + source.id,
                        "check the picked pairs, the pose and the unit");
    }
    ParameterSet parameters = scene.preprocess;
    const double finest =
        kVoxelsPerExtent * metres(source.data->points->bounds(), placement.targetFromSource);
    if (const auto voxel = parameters.optionalReal("voxel_m"); voxel && *voxel > finest)
        if (const Status set = parameters.set("voxel_m", finest); !set) return fail(set.error());
    auto clean = preprocess(near, parameters, unit, control);
    if (!clean) return fail(clean.error());
    return TriangleMesh{unit == 1 ? std::move(*clean) : clean->transformed(metresFromTarget), {}};
}

}  // namespace

bool needsRegistration(const SceneState& scene, const Layer& layer) {
    if (layer.id == scene.target) return false;
    return layer.role == LayerRole::handheld || !std::holds_alternative<InitIdentity>(layer.init);
}

Result<PreparedRegistration> prepareRegistration(const SceneState& scene, const std::string& layer,
                                                 const JobControl& control) {
    return guarded("layer " + layer, [&]() -> Result<PreparedRegistration> {
        const auto pair = findPair(scene, layer);
        if (!pair) return fail(pair.error());
        auto placement = initialPlacement(scene, *pair->source, *pair->target, control.sub(0, 0.7));
        if (!placement) return fail(placement.error());
        auto target = preparedTarget(scene, *pair->target, *pair->source, *placement, control.sub(0.7, 1));
        if (!target) return fail(target.error());
        return PreparedRegistration{std::move(*target), placement->targetFromSource, placement->error_m,
                                    std::move(placement->notes), std::move(placement->found)};
    });
}

namespace {

/// With registerGeometry or attemptRegistration.
Result<RegistrationResult> registerWith(decltype(registerGeometry)& method, const SceneState& scene,
                                        const std::string& layer, const PreparedRegistration& prepared,
                                        const JobControl& control, const RegistrationWatch& watch) {
    const auto pair = findPair(scene, layer);
    if (!pair) return fail(pair.error());
    ParameterSet parameters = scene.registration;
    if (prepared.error_m && parameters.isDefault("start_error_m"))
        if (const Status set = parameters.set("start_error_m", *prepared.error_m); !set)
            return fail(set.error());
    auto result =
        method(prepared.target, *pair->source->data->geometry, prepared.initial, parameters, control, watch);
    if (!result) {
        Error error = result.error();
        error.place = "layer " + layer + (error.place.empty() ? "" : ", " + error.place);
        return fail(std::move(error));
    }
    result->notes.insert(result->notes.begin(), prepared.notes.begin(), prepared.notes.end());
    if (prepared.found) addFirstPose(*result, *prepared.found);
    return result;
}

}  // namespace

Result<RegistrationResult> registerPrepared(const SceneState& scene, const std::string& layer,
                                            const PreparedRegistration& prepared, const JobControl& control,
                                            const RegistrationWatch& watch) {
    auto result = registerWith(registerGeometry, scene, layer, prepared, control, watch);
    if (result && !result->trustworthy())
        return fail(ErrorCode::untrustworthy, result->reasons.front(), "layer " + layer,
                    "give picked pairs as the first pose");
    return result;
}

Result<RegistrationResult> registerLayer(const SceneState& scene, const std::string& layer,
                                         const JobControl& control, const RegistrationWatch& watch) {
    const auto prepared = prepareRegistration(scene, layer, control.sub(0, 0.3));
    if (!prepared) return fail(prepared.error());
    return registerPrepared(scene, layer, *prepared, control.sub(0.3, 1), watch);
}

Result<RegistrationResult> attemptLayer(const SceneState& scene, const std::string& layer,
                                        const JobControl& control, const RegistrationWatch& watch) {
    const auto prepared = prepareRegistration(scene, layer, control.sub(0, 0.3));
    if (!prepared) return fail(prepared.error());
    return registerWith(attemptRegistration, scene, layer, *prepared, control.sub(0.3, 1), watch);
}

}  // namespace vestige
