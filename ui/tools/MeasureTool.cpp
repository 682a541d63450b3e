#include "ui/tools/MeasureTool.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>

#include "core/scene/Edits.h"
#include "core/scene/PickFrame.h"
#include "ui/document/Document.h"
#include "ui/document/Notices.h"
#include "ui/document/ObjectNames.h"
#include "ui/document/Selection.h"
#include "ui/document/Wording.h"
#include "ui/view/SceneView.h"

namespace vestige {

MeasureTool::MeasureTool(Document& document, Selection& selection, Notices& notices, HoverProbe& probe,
                         QObject* parent)
    : QObject(parent), document_(document), selection_(selection), notices_(notices), probe_(probe) {
    connect(&probe_, &HoverProbe::hovered, this, [this](const auto& under) { showPending(under); });
    connect(&selection_, &Selection::changed, this, [this] { tellHint(); });
    connect(&document_, &Document::changed, this, [this] { tellHint(); });
    connect(&document_, &Document::replaced, this, [this] { abandon(); });
}

void MeasureTool::enter(SceneView& view) {
    view_ = &view;
    view.widget()->setCursor(Qt::CrossCursor);
    tellHint();
}

void MeasureTool::leave(SceneView& view) {
    abandon();
    probe_.stop();
    view.widget()->unsetCursor();
    view_ = nullptr;
    emit hintChanged({});
}

bool MeasureTool::mousePress(SceneView&, const QMouseEvent& event) {
    pressed_ = event.pos();
    // The press also reaches navigation: only a release at the same place is a click.
    return false;
}

bool MeasureTool::mouseMove(SceneView& view, const QMouseEvent& event) {
    probe_.moved(view, event);
    return false;
}

bool MeasureTool::mouseRelease(SceneView& view, const QMouseEvent& event) {
    const auto from = pressed_;
    pressed_.reset();
    if (!from || (event.pos() - *from).manhattanLength() >= QApplication::startDragDistance()) return false;
    if (event.button() == Qt::LeftButton) click(view, event.pos());
    if (event.button() == Qt::RightButton) abandon();
    return false;
}

bool MeasureTool::keyPress(SceneView&, const QKeyEvent& event) {
    if (event.key() != Qt::Key_Escape || !first_) return false;
    abandon();
    return true;
}

std::optional<MeasureTool::End> MeasureTool::endAt(SceneView& view, const QPoint& position) const {
    const auto pick = view.pickAt(position);
    if (!pick) return std::nullopt;
    const auto& layers = view.description().layers;
    if (pick->layer >= layers.size()) return std::nullopt;
    const ViewLayer& shown = layers[pick->layer];
    const SceneState& scene = document_.state();
    const Layer* layer = scene.layer(shown.id);
    if (!layer) return std::nullopt;
    // Where the layer is shown before its registration, the point is taken to where the case has the layer.
    const Eigen::Vector3d world = sceneFromLayer(*layer) * (shown.worldFromLayer.inverse() * pick->world);
    // A first look is thinner than the cloud: the spacing is then taken from what the layer holds later.
    const bool whole = layer->data && !layer->data->isPreview();
    const auto spacing = whole ? std::optional(pick->localSpacing_m) : std::nullopt;
    return End{pickAt(scene, layer->id, world, spacing), pick->world};
}

void MeasureTool::click(SceneView& view, const QPoint& position) {
    const auto end = endAt(view, position);
    if (!end) return notices_.inform(tr("There is no point within 6 pixels of this click."));
    if (first_)
        complete(*end);
    else
        first_ = end;
    showPending(std::nullopt);
    tellHint();
}

void MeasureTool::complete(const End& second) {
    const PickedPair pair{first_->point, second.point};
    first_.reset();
    std::string object = selection_.object();
    const bool created = document_.state().measurement(object) == nullptr;
    if (created) object = freeObjectName(document_.state());
    if (created) {
        document_.begin(QString::fromStdString("pick " + object + ", repeat 1"));
        Measurement fresh;
        fresh.object = object;
        document_.perform(setMeasurement(std::move(fresh), "add " + object));
    }
    document_.perform(addPick(object, pair.a.layer, pair));
    if (created) document_.end();
    selection_.setMethod(methodOfKey(document_.state(), pair.a.layer));
    selection_.setObject(object);
    if (created) emit objectCreated(object);
}

void MeasureTool::abandon() {
    first_.reset();
    showPending(std::nullopt);
    tellHint();
}

void MeasureTool::showPending(const std::optional<Pick>& under) {
    if (!view_) return;
    if (!first_) return view_->setPendingMark(std::nullopt);
    ViewMark mark{first_->world, first_->world, {}, true};
    if (under) {
        mark.b = under->world;
        mark.label = lengthText((mark.b - mark.a).norm()).toStdString() + " m";
    }
    view_->setPendingMark(mark);
}

void MeasureTool::tellHint() {
    if (!view_) return;
    const Measurement* object = document_.state().measurement(selection_.object());
    const QString name = object ? QString::fromStdString(object->object) : tr("New object");
    const std::size_t done = object ? pickCount(*object, document_.state(), selection_.method()) : 0;
    const QString repeat = done < 3 ? tr("repeat %1 of 3").arg(done + 1) : tr("repeat %1").arg(done + 1);
    const QString step = first_ ? tr("click the second end, Esc gives up") : tr("click the first end");
    emit hintChanged(tr("%1, %2: %3").arg(name, repeat, step));
}

}  // namespace vestige
