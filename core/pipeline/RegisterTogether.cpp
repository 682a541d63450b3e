#include "core/pipeline/RegisterTogether.h"

#include "core/pipeline/RegisterLayers.h"
#include "core/pipeline/joint/AdjustLayers.h"
#include "core/pipeline/joint/PairLayers.h"

namespace vestige {

PreparedLayers prepareLayers(const SceneState& scene, const std::vector<std::string>& ids,
                             const JobControl& control) {
    PreparedLayers prepared;
    const auto count = static_cast<double>(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const Layer* layer = scene.layer(ids[i]);
        const std::string to = layer ? referenceOf(layer->init) : std::string();
        if (!to.empty() && to != scene.target) continue;
        const JobControl part =
            control.sub(static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
        prepared.emplace(ids[i], prepareRegistration(scene, ids[i], part));
    }
    return prepared;
}

Result<RegisteredLayers> registerLayers(const SceneState& scene, const std::vector<std::string>& ids,
                                        PreparedLayers prepared, const JobControl& control) {
    auto attempted = attemptLayers(scene, ids, std::move(prepared), control);
    if (!attempted) return fail(attempted.error());
    RegisteredLayers registered;
    for (AttemptedLayer& layer : attempted->layers) {
        if (layer.failure) return fail(*layer.failure);
        registered.layers.emplace_back(layer.id, std::move(*layer.result));
    }
    registered.adjustment = std::move(attempted->adjustment);
    return registered;
}

Result<RegisteredLayers> registerLayers(const SceneState& scene, const std::vector<std::string>& ids,
                                        const JobControl& control) {
    return registerLayers(scene, ids, {}, control);
}

Result<AttemptedLayers> attemptLayers(const SceneState& scene, const std::vector<std::string>& ids,
                                      PreparedLayers prepared, const JobControl& control,
                                      const LayerWatches& watches) {
    const auto paired = pairLayers(scene, ids, std::move(prepared), control, watches);
    if (!paired) return fail(paired.error());
    return adjustLayers(scene, *paired, control);
}

Result<AttemptedLayers> attemptLayers(const SceneState& scene, const std::vector<std::string>& ids,
                                      const JobControl& control, const LayerWatches& watches) {
    return attemptLayers(scene, ids, PreparedLayers{}, control, watches);
}

}  // namespace vestige
