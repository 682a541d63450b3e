#include "ui/shell/ScenePresenter.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/CameraProjection.h"
#include "core/pipeline/DescribeView.h"
#include "core/pipeline/FrameView.h"
#include "core/pipeline/FreeDirections.h"
#include "core/pipeline/KindPaths.h"
#include "core/scene/PickFrame.h"
#include "ui/document/Attempts.h"
#include "ui/document/Comparison.h"
#include "ui/document/Document.h"
#include "ui/document/PointMarks.h"
#include "ui/document/Presentation.h"
#include "ui/document/Preview.h"
#include "ui/document/Selection.h"
#include "ui/jobs/JobRunner.h"
#include "ui/view/SceneView.h"
#include "ui/watch/WatchedTime.h"

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

/// The camera moved along its direction until the box fills its picture.
ViewCamera lookAt(ViewCamera camera, const BoundingBox& box) {
    const double reach = 0.55 * std::max(box.diagonal(), 0.01);
    const double narrow = std::min(1.0, static_cast<double>(camera.width_px) / camera.height_px);
    const Eigen::Vector3d forward = camera.direction();
    camera.focalPoint = box.centre();
    camera.halfHeight_m = reach / narrow;
    const double distance =
        camera.parallel ? 4 * reach : reach / narrow / std::tan(0.5 * camera.verticalAngle_rad);
    camera.position = camera.focalPoint - distance * forward;
    return camera;
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

ScenePresenter::ScenePresenter(const Models& models, JobRunner& jobs, SceneView& view, QObject* parent)
    : QObject(parent), models_(models), jobs_(jobs), view_(view) {
    connect(&models_.document, &Document::replaced, this, [this] {
        frameAll_ = true;
        if (ownColors_.value_or(false) && models_.presentation.colorMode() == ColorMode::rgb)
            models_.presentation.setColorMode(ColorMode::source);
        ownColors_.reset();
        residuals_.clear();
    });
    connect(&models_.document, &Document::changed, this, [this] {
        chooseColors();
        refresh();
    });
    connect(&models_.presentation, &Presentation::changed, this, [this] { refresh(); });
    connect(&models_.presentation, &Presentation::sectionChanged, this,
            [this] { view_.setSection(models_.presentation.section()); });
    connect(&models_.preview, &Preview::changed, this, [this] { refresh(); });
    connect(&models_.comparison, &Comparison::switched, this, [this] { refresh(); });
    connect(&models_.comparison, &Comparison::adjusted, this,
            [this] { view_.setComparison(models_.comparison.shown()); });
    connect(&models_.selection, &Selection::changed, this, [this] { refreshMarks(); });
}

/// A single scan is shown in the colours it has, as it was photographed; beside another one in its own tint,
/// which tells them apart. Once in a case: what the user chooses stays.
void ScenePresenter::chooseColors() {
    const auto& layers = models_.document.state().layers;
    if (layers.empty() || !layers.front().data) return;
    const bool wanted = layers.size() == 1 && !layers.front().data->points->attributes().color.empty();
    const bool had = ownColors_.value_or(false);
    if (had == wanted || (ownColors_ && !had)) {
        ownColors_ = ownColors_.value_or(wanted);
        return;
    }
    ownColors_ = wanted;
    if (models_.presentation.colorMode() != (wanted ? ColorMode::source : ColorMode::rgb)) return;
    models_.presentation.setColorMode(wanted ? ColorMode::rgb : ColorMode::source);
}

void ScenePresenter::showNamedView(NamedView view) {
    const ViewDescription& described = view_.description();
    if (bounds(described).empty()) return;
    view_.setCamera(framedAll(described, view));
}

void ScenePresenter::showAll() {
    if (bounds(view_.description()).empty()) return;
    const ViewDescription placed = placedOnly(models_.document.state(), view_.description());
    const int strip = roomAbove();
    view_.changeCameras([&](ViewCamera camera) {
        camera.height_px -= strip;
        return withRoomAbove(framed(placed, camera), strip);
    });
}

ViewCamera ScenePresenter::framedAll(const ViewDescription& described, NamedView view) const {
    const int strip = roomAbove();
    const ViewCamera now = view_.camera();
    return withRoomAbove(
        frameView(placedOnly(models_.document.state(), described), view, now.width_px, now.height_px - strip),
        strip);
}

/// What the tools cover at the top, where they reach over half of the picture; not of several panes.
int ScenePresenter::roomAbove() const {
    if (view_.layout() != ViewLayout::one) return 0;
    double covered = 0;
    for (const QRectF& place : view_.covered())
        if (place.top() < 20 && place.width() > 0.5 * view_.camera().width_px)
            covered = std::max(covered, place.bottom());
    return static_cast<int>(std::min(covered, 0.3 * view_.camera().height_px));
}

BoundingBox ScenePresenter::placedBounds() const {
    return subjectBounds(placedOnly(models_.document.state(), view_.description()));
}

void ScenePresenter::showLayer() {
    const ShownFit fit = shownFit(models_.document, models_.selection, models_.attempts);
    const std::string& selected = models_.selection.layer();
    const std::string wanted = selected.empty() && fit.layer ? fit.layer->id : selected;
    ViewDescription alone = view_.description();
    std::erase_if(alone.layers, [&](const ViewLayer& layer) { return layer.id != wanted; });
    if (!bounds(alone).empty()) view_.setCamera(lookAt(view_.camera(), bounds(alone)));
}

void ScenePresenter::showObject() {
    BoundingBox box;
    const ViewDescription& shown = view_.description();
    for (const ViewMark& mark : shown.marks)
        if (mark.highlighted) box.add(mark.a), box.add(mark.b);
    for (const ViewPath& path : shown.paths)
        if (path.highlighted)
            for (const Eigen::Vector3d& point : path.points) box.add(point);
    if (box.empty()) return;
    // What the object is part of is to be seen, too.
    const Eigen::Vector3d room = Eigen::Vector3d::Constant(std::max(0.2, 0.25 * box.diagonal()));
    showBox({box.min - room, box.max + room});
}

void ScenePresenter::showBox(const BoundingBox& box) {
    if (!box.empty()) view_.setCamera(lookAt(view_.camera(), box));
}

void ScenePresenter::refreshPoints() {
    ViewDescription described = view_.description();
    models_.marks.apply(described);
    view_.show(std::move(described));
}

/// Distances to the target belong to one pose: a layer that is shown elsewhere goes without them.
Overlay ScenePresenter::overlayNow() const {
    const Overlay wanted = models_.presentation.overlay();
    const bool elsewhere =
        models_.preview.active() ||
        (models_.comparison.active() && models_.comparison.what() == Comparison::What::beforeAfter);
    return wanted == Overlay::residual && elsewhere ? Overlay::registration : wanted;
}

void ScenePresenter::refresh() {
    const WatchedTime watched("ScenePresenter::refresh");
    ++refreshes_;
    // Distances to the target take seconds on large clouds; the picture without them comes first.
    const bool residual = overlayNow() == Overlay::residual;
    auto described = describeView(models_.document.state(), models_.presentation.colorMode(),
                                  residual ? Overlay::none : overlayNow(), models_.presentation.before());
    const bool known = residual && residuals_.fill(described, models_.document.state());
    show(std::move(described));
    if (residual && !known) computeResiduals();
}

void ScenePresenter::computeResiduals() {
    jobs_.run<ViewDescription>(
        tr("Distances to the target"),
        [scene = models_.document.state(), mode = models_.presentation.colorMode(),
         before = models_.presentation.before()](const JobControl& control) -> Result<ViewDescription> {
            auto described = describeView(scene, mode, Overlay::residual, before, control);
            if (control.cancelled()) return fail(cancelledError());
            return described;
        },
        [this, asked = refreshes_](Result<ViewDescription> described) {
            if (!described || asked != refreshes_) return;
            residuals_.remember(*described, models_.document.state());
            show(std::move(*described));
        });
}

/// Whether the target is compared with it: what was registered to the target or is shown at a pose that was
/// found; any other layer, too, while there is none of these.
bool ScenePresenter::isSource(const Layer& layer) const {
    const SceneState& scene = models_.document.state();
    if (layer.id == scene.target) return false;
    const auto laidOn = [&](const Layer& one) {
        return one.id != scene.target && one.visible && one.data &&
               (one.registration || (models_.preview.active() && models_.preview.layer() == one.id));
    };
    return laidOn(layer) || std::none_of(scene.layers.begin(), scene.layers.end(), laidOn);
}

/// Where a layer lies and what of it is seen, in both pictures of a comparison.
void ScenePresenter::place(ViewLayer& shown) const {
    const Layer* layer = models_.document.state().layer(shown.id);
    const bool previewed = models_.preview.active() && models_.preview.layer() == shown.id;
    if (previewed) shown.worldFromLayer = models_.preview.sceneFromLayer();
    if (!models_.comparison.active() || !layer) return;
    if (models_.comparison.what() == Comparison::What::sourceTarget) {
        shown.other = ViewSide{shown.worldFromLayer, shown.isTarget};
        shown.visible = isSource(*layer);
        return;
    }
    const RegistrationResult* refused = models_.attempts.of(shown.id);
    if (previewed && refused)
        shown.other = ViewSide{refused->initial, true};
    else if (layer->registration)
        shown.other = ViewSide{layer->registration->initial, true};
}

void ScenePresenter::show(ViewDescription described) {
    described.pointSize_px = models_.presentation.pointSize_px();
    described.title.clear();  // stands in the header of the window
    described.theme = models_.presentation.theme();
    described.eyeDomeLighting = models_.presentation.eyeDomeLighting();
    described.coloring = models_.presentation.coloring();
    described.section = models_.presentation.section();
    described.sizeByDistance = models_.presentation.sizeByDistance();
    described.showGrid = models_.presentation.grid();
    described.showNorthArrow = models_.presentation.northArrow() && knowsNorth(models_.document.state());
    for (ViewLayer& shown : described.layers) place(shown);
    if (models_.comparison.active()) described.comparison = models_.comparison.shown();
    annotate(described);
    models_.marks.apply(described);
    std::vector<std::shared_ptr<const Octree>> octrees;
    for (const ViewLayer& shown : described.layers) {
        const Layer* layer = models_.document.state().layer(shown.id);
        octrees.push_back(layer && layer->data ? layer->data->octree : nullptr);
    }
    const bool frame = frameAll_ && !bounds(described).empty();
    if (frame) {
        described.camera = framedAll(described, NamedView::perspective);
        frameAll_ = false;
    } else {
        described.camera = view_.camera();
    }
    if (described.layers.empty()) frameAll_ = true;
    view_.show(std::move(described), frame);
    view_.setPickIndex(std::move(octrees));
}

/// Marks, and arrows along what the registration of the layer described leaves free.
void ScenePresenter::annotate(ViewDescription& described) const {
    described.marks = marksOf(models_.document.state(), models_.document.measured(),
                              models_.selection.object(), models_.selection.method());
    described.paths = measurementPaths(models_.document.state(), models_.document.measured(),
                                       models_.selection.method(), models_.selection.object());
    described.arrows.clear();
    if (!models_.presentation.freeDirections() || models_.preview.active()) return;
    const ShownFit fit = shownFit(models_.document, models_.selection, models_.attempts);
    if (fit.entered && fit.result->quality) described.arrows = freeDirectionArrows(*fit.result->quality);
}

void ScenePresenter::refreshMarks() {
    const WatchedTime watched("ScenePresenter::refreshMarks");
    ViewDescription described = view_.description();
    annotate(described);
    view_.show(std::move(described));
}

}  // namespace vestige
