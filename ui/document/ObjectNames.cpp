#include "ui/document/ObjectNames.h"

#include <algorithm>

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
    const std::string label = say(spec.label);
    return label.substr(0, std::min(label.find(" ("), label.find("\uff08")));
}

std::string methodOfKey(const SceneState& scene, const std::string& key) {
    const Layer* layer = scene.layer(key);
    return layer ? layer->method : key;
}

bool countsFor(const SceneState& scene, const std::string& key, const PickedPair& pair,
               const std::string& method) {
    return countsFor(scene, key, PickedPath{pair.a, pair.b}, method);
}

bool countsFor(const SceneState& scene, const std::string& key, const PickedPath& path,
               const std::string& method) {
    const std::string own = methodOfKey(scene, key);
    if (method.empty() || method == own) return true;
    const bool fitted = std::any_of(path.begin(), path.end(),
                                    [](const PickedPoint& point) { return point.fitted.has_value(); });
    return fitted && method == fittedMethod(own);
}

std::optional<PickPlace> lastPick(const Measurement& measurement, const SceneState& scene,
                                  const std::string& method) {
    std::optional<PickPlace> last;
    for (const auto& [key, pairs] : measurement.picks)
        for (std::size_t i = 0; i < pairs.size(); ++i)
            if (countsFor(scene, key, pairs[i], method)) last = PickPlace{key, i};
    for (const auto& [key, paths] : measurement.paths)
        for (std::size_t i = 0; i < paths.size(); ++i)
            if (countsFor(scene, key, paths[i], method)) last = PickPlace{key, i, true};
    return last;
}

std::size_t pickCount(const Measurement& measurement, const SceneState& scene, const std::string& method) {
    std::size_t count = 0;
    for (const auto& [key, pairs] : measurement.picks)
        for (const PickedPair& pair : pairs) count += countsFor(scene, key, pair, method);
    for (const auto& [key, paths] : measurement.paths)
        for (const PickedPath& path : paths) count += countsFor(scene, key, path, method);
    return count;
}

}  // namespace vestige
