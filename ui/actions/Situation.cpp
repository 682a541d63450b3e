#include "ui/actions/Situation.h"

#include "ui/document/Document.h"
#include "ui/document/ObjectNames.h"
#include "ui/document/Selection.h"
#include "ui/jobs/JobRunner.h"

namespace vestige {

Situation situationOf(const Document& document, const Selection& selection, const JobRunner& jobs) {
    const SceneState& scene = document.state();
    Situation now;
    now.busy = jobs.busy();
    now.layers = static_cast<int>(scene.layers.size());
    const Layer* target = scene.layer(scene.target);
    for (const Layer& layer : scene.layers) {
        now.loadedLayers += layer.data != nullptr;
        now.registered += layer.registration.has_value();
        now.registrable += layer.data && target && target->data && &layer != target;
    }
    now.canUndo = document.canUndo();
    now.canRedo = document.canRedo();
    now.modified = document.modified();
    now.layerSelected = scene.layer(selection.layer()) != nullptr;
    const Measurement* object = scene.measurement(selection.object());
    now.objectSelected = object != nullptr;
    now.hasPicks = object && pickCount(*object, scene, selection.method()) > 0;
    for (const MeasuredLength& length : document.measured().lengths)
        now.hasMeasured |= length.length.has_value();
    for (const Measurement& measurement : scene.measurements) now.hasAims |= !measurement.aims.empty();
    return now;
}

}  // namespace vestige
