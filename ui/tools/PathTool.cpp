#include "ui/tools/PathTool.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWidget>

#include "core/measurement/kinds/KindSpec.h"
#include "core/scene/Edits.h"
#include "core/scene/KindEdits.h"
#include "core/scene/PickFrame.h"
#include "ui/document/Document.h"
#include "ui/document/Notices.h"
#include "ui/document/ObjectNames.h"
#include "ui/document/Selection.h"
#include "ui/document/Wording.h"
#include "ui/view/PendingPath.h"
#include "ui/view/SceneView.h"

namespace vestige {

PathTool::PathTool(Document& document, Selection& selection, Notices& notices, HoverProbe& probe,
                   QObject* parent)
    : QObject(parent), document_(document), selection_(selection), notices_(notices), probe_(probe) {
    connect(&probe_, &HoverProbe::hovered, this, [this](const auto& under) { showPending(under); });
    connect(&selection_, &Selection::changed, this, [this] { tellHint(); });
    connect(&document_, &Document::changed, this, [this] { tellHint(); });
    connect(&document_, &Document::replaced, this, [this] { abandon(); });
}

const KindSpec& PathTool::spec() const {
    return kindSpec(kind_);
}

void PathTool::setKind(MeasurementKind kind) {
    abandon();
    kind_ = kind;
    tellHint();
}

void PathTool::enter(SceneView& view) {
    view_ = &view;
    view.widget()->setCursor(Qt::CrossCursor);
    tellHint();
}

void PathTool::leave(SceneView& view) {
    abandon();
    probe_.stop();
    view.widget()->unsetCursor();
    view_ = nullptr;
    emit hintChanged({});
}

bool PathTool::mousePress(SceneView&, const QMouseEvent& event) {
    pressed_.reset();
    if (!(event.modifiers() & Qt::AltModifier)) pressed_ = event.pos();
    // The press also reaches navigation: only a release at the same place is a click.
    return false;
}

bool PathTool::mouseMove(SceneView& view, const QMouseEvent& event) {
    probe_.moved(view, event);
    return false;
}

bool PathTool::mouseRelease(SceneView& view, const QMouseEvent& event) {
    const auto from = pressed_;
    pressed_.reset();
    if (!from || (event.pos() - *from).manhattanLength() >= QApplication::startDragDistance()) return false;
    if (event.button() == Qt::LeftButton) click(view, event.pos());
    if (event.button() == Qt::RightButton) finish();
    return false;
}

bool PathTool::mouseDoubleClick(SceneView&, const QMouseEvent& event) {
    // The first of the two clicks has added its point.
    if (event.button() != Qt::LeftButton || points_.empty()) return false;
    finish();
    return true;
}

void PathTool::paint(const SceneView&, QPainter& painter, const ViewCamera& camera,
                     const ViewTheme& theme) const {
    paintPendingPath(painter, theme, camera, world_);
}

bool PathTool::holdsKey(const SceneView&, const QKeyEvent& event) const {
    const int key = event.key();
    return !points_.empty() && event.modifiers() == Qt::NoModifier &&
           (key == Qt::Key_Escape || key == Qt::Key_Backspace || key == Qt::Key_Return ||
            key == Qt::Key_Enter);
}

bool PathTool::keyPress(SceneView&, const QKeyEvent& event) {
    if (points_.empty()) return false;
    switch (event.key()) {
        case Qt::Key_Escape:
            abandon();
            return true;
        case Qt::Key_Backspace:
            takeBack();
            return true;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            finish();
            return true;
        default:
            return false;
    }
}

void PathTool::click(SceneView& view, const QPoint& position) {
    const auto pick = view.pickAt(position);
    const auto& layers = view.description().layers;
    const Layer* layer =
        pick && pick->layer < layers.size() ? document_.state().layer(layers[pick->layer].id) : nullptr;
    if (!layer) return notices_.inform(tr("There is no point within 6 pixels of this click."));
    if (points_.size() >= kMostPathPoints)
        return notices_.inform(tr("A path has %1 points at most.").arg(kMostPathPoints));
    // Where the layer is shown before its registration, the point is taken to where the case has the layer.
    const Eigen::Vector3d world =
        sceneFromLayer(*layer) * (layers[pick->layer].worldFromLayer.inverse() * pick->world);
    // A first look is thinner than the cloud: the spacing is then taken from what the layer holds later.
    const bool whole = layer->data && !layer->data->isPreview();
    const auto spacing = whole ? std::optional(pick->localSpacing_m) : std::nullopt;
    points_.push_back(pickAt(document_.state(), layer->id, world, spacing));
    world_.push_back(pick->world);
    if (spec().most > 0 && points_.size() == spec().most) return complete();
    showPending(std::nullopt);
    tellHint();
}

void PathTool::finish() {
    if (points_.empty()) return;
    if (points_.size() < spec().fewest)
        return notices_.inform(tr("This needs %1 points or more; there are %2. Esc gives up.")
                                   .arg(spec().fewest)
                                   .arg(points_.size()));
    complete();
}

void PathTool::complete() {
    const PickedPath path = std::exchange(points_, {});
    world_.clear();
    const std::string key = path.front().layer;
    const Measurement* selected = document_.state().measurement(selection_.object());
    const bool created = !selected || selected->kind != kind_;
    const std::string object =
        created ? freeObjectName(document_.state(), shortLabel(spec())) : selection_.object();
    if (created) {
        document_.begin(tr("pick %1, repeat 1").arg(QString::fromStdString(object)));
        Measurement fresh;
        fresh.object = object;
        fresh.kind = kind_;
        document_.perform(setMeasurement(std::move(fresh), "add " + object));
    }
    if (spec().isPair())
        document_.perform(addPick(object, key, {path[0], path[1]}));
    else
        document_.perform(addPath(object, key, path));
    if (created) document_.end();
    selection_.setMethod(methodOfKey(document_.state(), key));
    selection_.setObject(object);
    showPending(std::nullopt);
    tellHint();
    if (created) emit objectCreated(object);
}

void PathTool::takeBack() {
    points_.pop_back();
    world_.pop_back();
    showPending(std::nullopt);
    tellHint();
}

void PathTool::abandon() {
    points_.clear();
    world_.clear();
    showPending(std::nullopt);
    tellHint();
}

void PathTool::showPending(const std::optional<Pick>& under) {
    if (!view_) return;
    view_->updateOverlay();
    if (world_.empty() || !under) return view_->setPendingMark(std::nullopt);
    ViewMark mark{world_.back(), under->world, {}, true};
    mark.label = lengthText((mark.b - mark.a).norm()).toStdString() + " m";
    view_->setPendingMark(mark);
}

void PathTool::tellHint() {
    if (!view_) return;
    const Measurement* object = document_.state().measurement(selection_.object());
    const bool again = object && object->kind == kind_;
    const QString name =
        again ? QString::fromStdString(object->object) : tr("New: %1").arg(said(spec().label));
    const std::size_t done = again ? pickCount(*object, document_.state(), selection_.method()) : 0;
    const QString repeat = done < 3 ? tr("repeat %1 of 3").arg(done + 1) : tr("repeat %1").arg(done + 1);
    QString step = tr("click %1").arg(said(spec().pickName(points_.size())));
    if (!points_.empty()) {
        if (spec().most != spec().fewest && points_.size() >= spec().fewest)
            step += tr("; double click or Enter ends");
        step += tr("; Backspace takes the last point back, Esc gives up");
    }
    emit hintChanged(tr("%1, %2: %3").arg(name, repeat, step));
}

}  // namespace vestige
