#include "core/pipeline/MeasurementMarks.h"

#include "core/measurement/MeasuredText.h"
#include "core/measurement/kinds/KindSpec.h"
#include "core/pipeline/DescribeView.h"
#include "core/scene/PickFrame.h"

namespace vestige {
namespace {

/// The method that a pair under `key` (a layer's id, or a method) counts for, as measureScene has it.
std::string methodOf(const SceneState& scene, const std::string& key, const PickedPair& pair) {
    if (const Layer* layer = scene.layer(key)) return layer->method;
    for (const Layer& layer : scene.layers)
        if (layer.method == key) return key;
    const Layer* layer = scene.layer(pair.a.layer);
    return layer ? layer->method : std::string();
}

}  // namespace

std::optional<ViewMark> measurementMark(const SceneState& scene, const MeasuredLength& length) {
    const Measurement* measurement = scene.measurement(length.object);
    if (!measurement || !length.length) return std::nullopt;
    // What is picked as a path is drawn as one.
    if (length.fitted && !kindSpec(measurement->kind).isPair()) return std::nullopt;
    if (length.fitted)
        return ViewMark{length.a, length.b,
                        measuredSentence(length.length->mean_m, length.length->expandedUncertainty_m), false,
                        length.object};
    ViewMark mark{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                  measuredSentence(length.length->mean_m, length.length->expandedUncertainty_m), false,
                  length.object};
    double count = 0;
    for (const auto& [key, pairs] : measurement->picks) {
        for (const PickedPair& pair : pairs) {
            if (methodOf(scene, key, pair) != length.method) continue;
            mark.a += scenePosition(scene, pair.a);
            mark.b += scenePosition(scene, pair.b);
            ++count;
        }
    }
    if (count == 0) return std::nullopt;
    mark.a /= count;
    mark.b /= count;
    return mark;
}

std::vector<ViewMark> measurementMarks(const SceneState& scene, const MeasuredScene& measured) {
    std::vector<ViewMark> marks;
    for (const MeasuredLength& length : measured.lengths)
        if (auto mark = measurementMark(scene, length)) marks.push_back(std::move(*mark));
    return marks;
}

}  // namespace vestige
