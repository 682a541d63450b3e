#include "ui/document/ObjectNames.h"

#include "core/base/Translation.h"
#include "core/scene/MeasuredScene.h"

namespace vestige {

std::string freeObjectName(const SceneState& scene, const std::string& word) {
    for (int n = 1;; ++n) {
        std::string name = (word.empty() ? say("Length") : word) + " " + std::to_string(n);
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

bool countsFor(const SceneState& scene, const std::string& key, const PickedPair& pair,
               const std::string& method) {
    const std::string own = methodOfKey(scene, key);
    return method.empty() || method == own ||
           ((pair.a.fitted || pair.b.fitted) && method == fittedMethod(own));
}

std::optional<PickPlace> lastPick(const Measurement& measurement, const SceneState& scene,
                                  const std::string& method) {
    std::optional<PickPlace> last;
    for (const auto& [key, pairs] : measurement.picks)
        for (std::size_t i = 0; i < pairs.size(); ++i)
            if (countsFor(scene, key, pairs[i], method)) last = PickPlace{key, i};
    for (const auto& [key, paths] : measurement.paths)
        if (!paths.empty() && (method.empty() || methodOfKey(scene, key) == method))
            last = PickPlace{key, paths.size() - 1, true};
    return last;
}

std::size_t pickCount(const Measurement& measurement, const SceneState& scene, const std::string& method) {
    std::size_t count = 0;
    for (const auto& [key, pairs] : measurement.picks)
        for (const PickedPair& pair : pairs) count += countsFor(scene, key, pair, method);
    for (const auto& [key, paths] : measurement.paths)
        if (method.empty() || methodOfKey(scene, key) == method) count += paths.size();
    return count;
}

}  // namespace vestige
