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
                                        PreparedLayers prepared, const JobControl& control,
                                        const RegistrationWatch& watch) {
    const auto paired = pairLayers(scene, ids, std::move(prepared), control, watch);
    if (!paired) return fail(paired.error());
    return adjustLayers(scene, *paired);
}

Result<RegisteredLayers> registerLayers(const SceneState& scene, const std::vector<std::string>& ids,
                                        const JobControl& control, const RegistrationWatch& watch) {
    return registerLayers(scene, ids, {}, control, watch);
}

}  // namespace vestige
