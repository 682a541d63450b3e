#include "core/pipeline/KindPaths.h"

#include "core/measurement/kinds/KindSpec.h"
#include "core/report/QuantityText.h"
#include "core/scene/KindRepeats.h"
#include "core/scene/PickFrame.h"

namespace vestige {
namespace {

/// The last path that counts for the method.
const PickedPath* lastPath(const SceneState& scene, const Measurement& measurement,
                           const std::string& method) {
    const PickedPath* last = nullptr;
    for (const auto& [key, paths] : measurement.paths)
        for (const PickedPath& path : paths)
            if (!path.empty() && methodOfRepeat(scene, key, path.front()) == method) last = &path;
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
        if (kind.quantities.empty() || (!method.empty() && kind.method != method)) continue;
        const Measurement* measurement = scene.measurement(kind.object);
        if (!measurement || kindSpec(kind.kind).isPair()) continue;
        const PickedPath* picked = lastPath(scene, *measurement, kind.method);
        if (!picked) continue;
        ViewPath path;
        for (const PickedPoint& point : *picked)
            if (scene.layer(point.layer)) path.points.push_back(scenePosition(scene, point));
        path.label = quantitySentence(kind.quantities.front());
        path.closed = isClosed(kind.kind);
        path.highlighted = kind.object == selected;
        path.name = kind.object;
        paths.push_back(std::move(path));
    }
    return paths;
}

}  // namespace vestige
