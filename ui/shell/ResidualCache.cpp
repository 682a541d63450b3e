#include "ui/shell/ResidualCache.h"

namespace vestige {
namespace {

bool samePlace(const Similarity& a, const Similarity& b) {
    return a.scale == b.scale && a.pose.matrix() == b.pose.matrix();
}

/// The target, where the layer has distances to it.
const Layer* targetOf(const ViewLayer& shown, const SceneState& scene) {
    const Layer* layer = scene.layer(shown.id);
    const Layer* target = scene.layer(scene.target);
    return layer && layer->registration && target && target->data ? target : nullptr;
}

}  // namespace

void ResidualCache::remember(const ViewDescription& described, const SceneState& scene) {
    std::erase_if(known_, [](const auto& entry) { return entry.second.cloud.expired(); });
    for (const ViewLayer& shown : described.layers)
        if (const Layer* target = targetOf(shown, scene))
            known_[shown.id] = {shown.geometry, target->data, shown.worldFromLayer, sceneFromLayer(*target),
                                shown.residual_m};
}

bool ResidualCache::fill(ViewDescription& described, const SceneState& scene) const {
    std::vector<std::shared_ptr<const std::vector<float>>> found;
    for (const ViewLayer& shown : described.layers) {
        found.emplace_back();
        const Layer* target = targetOf(shown, scene);
        if (!target) continue;
        const auto known = known_.find(shown.id);
        if (known == known_.end()) return false;
        const Known& one = known->second;
        if (one.cloud.lock() != shown.geometry || one.target.lock() != target->data ||
            !samePlace(one.place, shown.worldFromLayer) ||
            !samePlace(one.targetPlace, sceneFromLayer(*target)))
            return false;
        found.back() = one.distances;
    }
    for (std::size_t i = 0; i < found.size(); ++i) described.layers[i].residual_m = found[i];
    described.overlay = Overlay::residual;
    return true;
}

}  // namespace vestige
