#include "core/pipeline/KindPaths.h"

#include <utility>

#include "core/measurement/kinds/KindSpec.h"
#include "core/report/QuantityText.h"
#include "core/scene/KindRepeats.h"
#include "core/scene/MeasuredScene.h"

namespace vestige {
namespace {

/// The last path that counts for the method, and whether it counts by what was fitted round its points.
std::pair<const PickedPath*, bool> lastPath(const SceneState& scene, const Measurement& measurement,
                                            const std::string& method) {
    std::pair<const PickedPath*, bool> last{nullptr, false};
    for (const auto& [key, paths] : measurement.paths)
        for (const PickedPath& path : paths) {
            if (path.empty()) continue;
            const std::string own = methodOfRepeat(scene, key, path.front());
            if (own == method || fittedMethod(own) == method) last = {&path, own != method};
        }
    return last;
}

bool isClosed(MeasurementKind kind) {
    return kind == MeasurementKind::area || kind == MeasurementKind::volume ||
           kind == MeasurementKind::circle;
}

}  // namespace

std::vector<ViewPath> measurementPaths(const SceneState& scene, const MeasuredScene& measured,
                                       const std::string& method, const std::string& selected) {
    std::vector<ViewPath> paths;
    for (const MeasuredKind& kind : measured.kinds) {
        if (!method.empty() && kind.method != method) continue;
        const Measurement* measurement = scene.measurement(kind.object);
        if (!measurement || kindSpec(kind.kind).isPair()) continue;
        const auto [picked, fitted] = lastPath(scene, *measurement, kind.method);
        if (!picked) continue;
        ViewPath path;
        for (const PickedPoint& point : *picked)
            if (scene.layer(point.layer)) path.points.push_back(kindEnd(scene, point, fitted).position);
        // What is not computed yet, or cannot be, is seen all the same.
        if (!kind.quantities.empty()) path.label = quantitySentence(kind.quantities.front());
        path.closed = isClosed(kind.kind);
        path.highlighted = kind.object == selected;
        path.name = kind.object;
        paths.push_back(std::move(path));
    }
    return paths;
}

}  // namespace vestige
