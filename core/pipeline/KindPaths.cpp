#include "core/pipeline/KindPaths.h"

#include <algorithm>
#include <utility>

#include "core/measurement/kinds/KindSpec.h"
#include "core/pipeline/KindStrokes.h"
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

/// A path without any feature is a row of the fitted method by its points: these are drawn then.
bool standsIn(const MeasuredScene& measured, const MeasuredKind& plain, const std::string& method) {
    return fittedMethod(plain.method) == method &&
           std::none_of(measured.kinds.begin(), measured.kinds.end(), [&](const MeasuredKind& kind) {
               return kind.object == plain.object && kind.method == method;
           });
}

}  // namespace

std::vector<ViewPath> measurementPaths(const SceneState& scene, const MeasuredScene& measured,
                                       const std::string& method, const std::string& selected) {
    std::vector<ViewPath> paths;
    for (const MeasuredKind& kind : measured.kinds) {
        if (!method.empty() && kind.method != method && !standsIn(measured, kind, method)) continue;
        const Measurement* measurement = scene.measurement(kind.object);
        if (!measurement || kindSpec(kind.kind).isPair()) continue;
        const auto [picked, fitted] = lastPath(scene, *measurement, kind.method);
        if (!picked) continue;
        const std::size_t first = paths.size();
        std::vector<Eigen::Vector3d> picks;
        for (const PickedPoint& point : *picked)
            if (scene.layer(point.layer)) picks.push_back(kindEnd(scene, point, fitted).position);
        for (KindStroke& stroke : strokesOf(kind.kind, measurement->settings, picks)) {
            ViewPath path;
            path.points = std::move(stroke.points);
            path.closed = stroke.closed;
            path.highlighted = kind.object == selected;
            path.name = kind.object;
            paths.push_back(std::move(path));
        }
        // What is not computed yet, or cannot be, is seen all the same. The label is of the first stroke.
        if (!kind.quantities.empty()) paths[first].label = quantitySentence(kind.quantities.front());
    }
    return paths;
}

}  // namespace vestige
