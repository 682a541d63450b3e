#include "ui/actions/Situation.h"

#include "ui/document/Attempts.h"
#include "ui/document/Comparison.h"
#include "ui/document/Document.h"
#include "ui/document/ObjectNames.h"
#include "ui/document/PointSelection.h"
#include "ui/document/Preview.h"
#include "ui/document/Selection.h"
#include "ui/jobs/JobRunner.h"

namespace vestige {

Situation situationOf(const Document& document, const Selection& selection, const JobRunner& jobs,
                      const Attempts& attempts, const Preview& preview, const Comparison& comparison,
                      const PointSelection* points) {
    const SceneState& scene = document.state();
    Situation now;
    now.busy = jobs.busy();
    now.layers = static_cast<int>(scene.layers.size());
    const Layer* target = scene.layer(scene.target);
    for (const Layer& layer : scene.layers) {
        now.loadedLayers += layer.data != nullptr;
        now.registered += layer.registration.has_value();
        const bool whole = layer.data && !layer.data->isPreview();
        const bool wholeTarget = target && target->data && !target->data->isPreview();
        now.registrable += whole && wholeTarget && &layer != target;
    }
    const ShownFit fit = shownFit(document, selection, attempts);
    now.refused = fit.layer && !fit.entered;
    now.candidates = now.refused && !fit.result->candidates.empty();
    now.comparing = comparison.active();
    now.previewing = preview.active();
    now.canUndo = document.canUndo();
    now.canRedo = document.canRedo();
    now.modified = document.modified();
    now.layerSelected = scene.layer(selection.layer()) != nullptr;
    const Measurement* object = scene.measurement(selection.object());
    now.objectSelected = object != nullptr;
    now.hasPicks = object && pickCount(*object, scene, selection.method()) > 0;
    for (const MeasuredLength& length : document.measured().lengths)
        now.hasMeasured |= length.length.has_value();
    for (const MeasuredKind& kind : document.measured().kinds) now.hasMeasured |= !kind.quantities.empty();
    for (const Measurement& measurement : scene.measurements) {
        now.hasAims |= !measurement.aims.empty();
        now.anyPicks |= !measurement.picks.empty() || !measurement.paths.empty();
    }
    now.pointsSelected = points && points->size() > 0;
    now.partSelected = points && !points->object().empty();
    for (const Layer& layer : scene.layers) now.cleaned |= layer.cleaning != nullptr;
    return now;
}

}  // namespace vestige
