#include "core/pipeline/RegisterLayers.h"

#include "core/pipeline/InitialPlacement.h"

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

}  // namespace

bool needsRegistration(const SceneState& scene, const Layer& layer) {
    if (layer.id == scene.target) return false;
    if (layer.role == LayerRole::aerial && scene.registration.boolean("strips")) return true;
    return layer.role == LayerRole::handheld || !std::holds_alternative<InitIdentity>(layer.init);
}

Result<PreparedRegistration> prepareRegistration(const SceneState& scene, const std::string& layer,
                                                 const JobControl& control) {
    return guarded("layer " + layer, [&]() -> Result<PreparedRegistration> {
        const auto pair = findPair(scene, layer);
        if (!pair) return fail(pair.error());
        const auto placement = initialPlacement(scene, *pair->source, *pair->target, control.sub(0, 0.7));
        if (!placement) return fail(placement.error());
        return preparePair(scene, *pair->target, *pair->source, *placement, control.sub(0.7, 1));
    });
}

Result<RegistrationResult> registerPrepared(const SceneState& scene, const std::string& layer,
                                            const PreparedRegistration& prepared, const JobControl& control,
                                            const RegistrationWatch& watch) {
    const auto pair = findPair(scene, layer);
    if (!pair) return fail(pair.error());
    return registerPair(scene, *pair->source, prepared, control, watch);
}

Result<RegistrationResult> registerLayer(const SceneState& scene, const std::string& layer,
                                         const JobControl& control, const RegistrationWatch& watch) {
    const auto prepared = prepareRegistration(scene, layer, control.sub(0, 0.3));
    if (!prepared) return fail(prepared.error());
    return registerPrepared(scene, layer, *prepared, control.sub(0.3, 1), watch);
}

}  // namespace vestige
