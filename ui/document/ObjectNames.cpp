#include "ui/document/ObjectNames.h"

#include "core/base/Translation.h"
#include "core/scene/MeasuredScene.h"

namespace vestige {

std::string freeObjectName(const SceneState& scene) {
    for (int n = 1;; ++n) {
        std::string name = say("Length") + " " + std::to_string(n);
        if (!scene.measurement(name)) return name;
    }
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
    return last;
}

std::size_t pickCount(const Measurement& measurement, const SceneState& scene, const std::string& method) {
    std::size_t count = 0;
    for (const auto& [key, pairs] : measurement.picks)
        for (const PickedPair& pair : pairs) count += countsFor(scene, key, pair, method);
    return count;
}

}  // namespace vestige
