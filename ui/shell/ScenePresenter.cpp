#include "ui/shell/ScenePresenter.h"

#include <algorithm>

#include "core/pipeline/DescribeView.h"
#include "core/pipeline/FrameView.h"
#include "core/scene/PickFrame.h"
#include "ui/document/Document.h"
#include "ui/document/Presentation.h"
#include "ui/document/Selection.h"
#include "ui/jobs/JobRunner.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {

/// The marks of the selected object stand out from the others.
std::vector<ViewMark> marksOf(const SceneState& scene, const MeasuredScene& measured,
                              const std::string& object, const std::string& method) {
    MeasuredScene others, selected;
    for (const MeasuredLength& length : measured.lengths) {
        if (!method.empty() && length.method != method) continue;
        (length.object == object ? selected : others).lengths.push_back(length);
    }
    auto marks = measurementMarks(scene, others);
    for (ViewMark& mark : measurementMarks(scene, selected)) {
        mark.highlighted = true;
        marks.push_back(std::move(mark));
    }
    return marks;
}

/// A scan that is not registered yet lies in a frame of its own, perhaps far away: it takes no part in
/// framing while another layer has its place.
ViewDescription placedOnly(const SceneState& scene, const ViewDescription& described) {
    ViewDescription placed = described;
    for (ViewLayer& shown : placed.layers) {
        const Layer* layer = scene.layer(shown.id);
        shown.visible = shown.visible && layer && isPlaced(scene, *layer);
    }
    return bounds(placed).empty() ? described : placed;
}

}  // namespace

ScenePresenter::ScenePresenter(Document& document, Selection& selection, Presentation& presentation,
                               JobRunner& jobs, SceneView& view, QObject* parent)
    : QObject(parent),
      document_(document),
      selection_(selection),
      presentation_(presentation),
      jobs_(jobs),
      view_(view) {
    connect(&document_, &Document::replaced, this, [this] { frameAll_ = true; });
    connect(&document_, &Document::changed, this, [this] { refresh(); });
    connect(&presentation_, &Presentation::changed, this, [this] { refresh(); });
    connect(&selection_, &Selection::changed, this, [this] { refreshMarks(); });
}

void ScenePresenter::showNamedView(NamedView view) {
    const ViewDescription& described = view_.description();
    if (bounds(described).empty()) return;
    view_.setCamera(frameView(placedOnly(document_.state(), described), view,
                              std::max(1, view_.widget()->width()), std::max(1, view_.widget()->height())));
}

void ScenePresenter::refresh() {
    ++refreshes_;
    // Distances to the target take seconds on large clouds; the picture without them comes first.
    const bool residual = presentation_.overlay() == Overlay::residual;
    show(describeView(document_.state(), presentation_.colorMode(),
                      residual ? Overlay::none : presentation_.overlay(), presentation_.before()));
    if (residual) computeResiduals();
}

void ScenePresenter::computeResiduals() {
    jobs_.run<ViewDescription>(
        tr("Distances to the target"),
        [scene = document_.state(), mode = presentation_.colorMode(),
         before = presentation_.before()](const JobControl& control) -> Result<ViewDescription> {
            auto described = describeView(scene, mode, Overlay::residual, before);
            if (control.cancelled()) return fail(cancelledError());
            return described;
        },
        [this, asked = refreshes_](Result<ViewDescription> described) {
            if (described && asked == refreshes_) show(std::move(*described));
        });
}

void ScenePresenter::show(ViewDescription described) {
    described.pointSize_px = presentation_.pointSize_px();
    described.eyeDomeLighting = presentation_.eyeDomeLighting();
    described.marks =
        marksOf(document_.state(), document_.measured(), selection_.object(), selection_.method());
    std::vector<std::shared_ptr<const Octree>> octrees;
    for (const ViewLayer& shown : described.layers) {
        const Layer* layer = document_.state().layer(shown.id);
        octrees.push_back(layer && layer->data ? layer->data->octree : nullptr);
    }
    const bool frame = frameAll_ && !bounds(described).empty();
    if (frame) {
        described.camera =
            frameView(placedOnly(document_.state(), described), NamedView::perspective,
                      std::max(1, view_.widget()->width()), std::max(1, view_.widget()->height()));
        frameAll_ = false;
    } else {
        described.camera = view_.camera();
    }
    if (described.layers.empty()) frameAll_ = true;
    view_.show(std::move(described), frame);
    view_.setPickIndex(std::move(octrees));
}

void ScenePresenter::refreshMarks() {
    ViewDescription described = view_.description();
    described.marks =
        marksOf(document_.state(), document_.measured(), selection_.object(), selection_.method());
    view_.show(std::move(described));
}

}  // namespace vestige
