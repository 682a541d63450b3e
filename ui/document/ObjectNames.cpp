#include "ui/document/ObjectNames.h"

#include "core/base/Translation.h"

namespace vestige {

std::string freeObjectName(const SceneState& scene, const std::string& word) {
    for (int n = 1;; ++n) {
        std::string name =
            word.empty() ? say("Length %1", {std::to_string(n)}) : word + " " + std::to_string(n);
        if (!scene.measurement(name)) return name;
    }
}

std::string shortLabel(const KindSpec& spec) {
    return spec.label.substr(0, spec.label.find(" ("));
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
    for (const auto& [key, paths] : measurement.paths)
        if (!paths.empty() && (method.empty() || methodOfKey(scene, key) == method))
            last = PickPlace{key, paths.size() - 1, true};
    return last;
}

std::size_t pickCount(const Measurement& measurement, const SceneState& scene, const std::string& method) {
    std::size_t count = 0;
    for (const auto& [key, pairs] : measurement.picks)
        if (method.empty() || methodOfKey(scene, key) == method) count += pairs.size();
    for (const auto& [key, paths] : measurement.paths)
        if (method.empty() || methodOfKey(scene, key) == method) count += paths.size();
    return count;
}

}  // namespace vestige
