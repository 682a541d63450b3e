#include "core/pipeline/RegisterPair.h"

#include "core/base/Parallel.h"
#include "core/filters/Preprocess.h"
#include "core/registration/Register.h"

namespace vestige {
namespace {

/// The points inside the box (metres), in their order.
PointCloud cropped(const PointCloud& cloud, double metresPerUnit, const BoundingBox& box) {
    constexpr std::size_t kGrain = 1 << 16;
    std::vector<std::vector<std::uint32_t>> parts((cloud.size() + kGrain - 1) / kGrain);
    parallelChunks(cloud.size(), kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (box.contains(metresPerUnit * cloud.point(i)))
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
    const PointCloud* near = target.data->points.get();
    PointCloud cut;
    if (placement.reach_m) {
        BoundingBox box = source.data->points->bounds().transformed(placement.targetFromSource);
        box.min.array() -= *placement.reach_m;
        box.max.array() += *placement.reach_m;
        cut = cropped(*near, unit, box);
        near = &cut;
        if (cut.empty())
            return fail(ErrorCode::untrustworthy,
                        "the first pose puts the scan where the target has no points", "layer " + source.id,
                        "check the picked pairs, the pose and the unit");
    }
    ParameterSet parameters = scene.preprocess;
    const double finest =
        kVoxelsPerExtent * metres(source.data->points->bounds(), placement.targetFromSource);
    if (const auto voxel = parameters.optionalReal("voxel_m"); voxel && *voxel > finest)
        parameters.setNearest("voxel_m", finest);
    auto clean = preprocess(*near, parameters, unit, control);
    if (!clean) return fail(clean.error());
    return TriangleMesh{unit == 1 ? std::move(*clean) : clean->transformed(metresFromTarget), {}};
}

}  // namespace

Result<PreparedRegistration> preparePair(const SceneState& scene, const Layer& target, const Layer& source,
                                         const InitialPlacement& placement, const JobControl& control) {
    return guarded("layer " + source.id, [&]() -> Result<PreparedRegistration> {
        auto prepared = preparedTarget(scene, target, source, placement, control);
        if (!prepared) return fail(prepared.error());
        return PreparedRegistration{std::move(*prepared), placement.targetFromSource,
                                    placement.error_m,    {},
                                    placement.notes,      placement.found};
    });
}

Result<RegistrationResult> attemptPair(const SceneState& scene, const Layer& source,
                                       const PreparedRegistration& prepared, const JobControl& control,
                                       const RegistrationWatch& watch) {
    ParameterSet parameters = scene.registration;
    if (prepared.error_m && parameters.isDefault("start_error_m"))
        parameters.setNearest("start_error_m", *prepared.error_m);
    if (prepared.voxelStart_m && parameters.isDefault("voxel_start_m"))
        parameters.setNearest("voxel_start_m", *prepared.voxelStart_m);
    auto result = attemptRegistration(prepared.target, *source.data->geometry, prepared.initial, parameters,
                                      control, watch);
    if (!result) {
        Error error = result.error();
        error.place = "layer " + source.id + (error.place.empty() ? "" : ", " + error.place);
        return fail(std::move(error));
    }
    result->notes.insert(result->notes.begin(), prepared.notes.begin(), prepared.notes.end());
    if (prepared.found) addFirstPose(*result, *prepared.found);
    return result;
}

Result<RegistrationResult> registerPair(const SceneState& scene, const Layer& source,
                                        const PreparedRegistration& prepared, const JobControl& control,
                                        const RegistrationWatch& watch) {
    auto result = attemptPair(scene, source, prepared, control, watch);
    if (result && !result->trustworthy()) return fail(unreliable(*result, source.id));
    return result;
}

Error unreliable(const RegistrationResult& result, const std::string& layer) {
    const bool ambiguous = result.verdict == Verdict::ambiguous;
    std::string why = result.reasons.empty() ? std::string(describe(result.verdict)) : result.reasons.front();
    return {ErrorCode::untrustworthy,
            ambiguous ? std::move(why) : "the registration cannot be relied on: " + why, "layer " + layer,
            ambiguous ? "give picked pairs as the first pose"
                      : "check that the clouds show the same place, and give a nearer first pose"};
}

}  // namespace vestige
