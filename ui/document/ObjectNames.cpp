#include "ui/document/ObjectNames.h"

#include "core/base/Translation.h"

namespace vestige {

std::string freeObjectName(const SceneState& scene) {
    for (int n = 1;; ++n) {
        std::string name = say("Length %1", {std::to_string(n)});
        if (!scene.measurement(name)) return name;
    }
}

std::string methodOfKey(const SceneState& scene, const std::string& key) {
    const Layer* layer = scene.layer(key);
    return layer ? layer->method : key;
}

std::optional<PickPlace> lastPick(const Measurement& measurement, const SceneState& scene,
                                  const std::string& method) {
    std::optional<PickPlace> last;
    for (const auto& [key, pairs] : measurement.picks)
        if (!pairs.empty() && (method.empty() || methodOfKey(scene, key) == method))
            last = PickPlace{key, pairs.size() - 1};
    return last;
}

std::size_t pickCount(const Measurement& measurement, const SceneState& scene, const std::string& method) {
    std::size_t count = 0;
    for (const auto& [key, pairs] : measurement.picks)
        if (method.empty() || methodOfKey(scene, key) == method) count += pairs.size();
    return count;
}

}  // namespace vestige
