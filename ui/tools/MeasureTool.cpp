#include "ui/tools/MeasureTool.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>

#include "core/measurement/kinds/KindSpec.h"
#include "core/scene/Edits.h"
#include "core/scene/MeasuredScene.h"
#include "ui/document/Document.h"
#include "ui/document/ObjectNames.h"
#include "ui/document/PickChoices.h"
#include "ui/document/Selection.h"
#include "ui/document/Wording.h"
#include "ui/tools/PickFeedback.h"
#include "ui/tools/PickMover.h"
#include "ui/tools/PickProbe.h"
#include "ui/tools/PickWords.h"
#include "ui/view/SceneView.h"

namespace vestige {

MeasureTool::MeasureTool(Document& document, Selection& selection, const PickAids& aids, QObject* parent)
    : QObject(parent), document_(document), selection_(selection), aids_(aids) {
    connect(&aids_.probe, &PickProbe::hovered, this, [this](const ProbedPlace& place) { show(place); });
    connect(&aids_.probe, &PickProbe::left, this, [this] {
        if (!view_) return;
        aids_.feedback.hide();
        showPending(std::nullopt);
    });
    connect(&aids_.mover, &PickMover::told, this, [this](const QString& sentence) {
        problem_ = sentence;
        tellHint();
    });
    connect(&selection_, &Selection::changed, this, [this] { tellHint(); });
    connect(&document_, &Document::changed, this, [this] { tellHint(); });
    connect(&document_, &Document::replaced, this, [this] { abandon(); });
    connect(&aids_.choices, &PickChoices::changed, this, [this] {
        problem_.clear();
        tellHint();
    });
}

void MeasureTool::enter(SceneView& view) {
    view_ = &view;
    view.widget()->setCursor(Qt::CrossCursor);
    view.widget()->setFocus();
    problem_.clear();
    last_.reset();
    tellHint();
    view.updateOverlay();
}

void MeasureTool::leave(SceneView& view) {
    abandon();
    aids_.mover.leave(view);
    aids_.probe.stop();
    aids_.feedback.hide();
    view.widget()->unsetCursor();
    view.updateOverlay();
    view_ = nullptr;
    emit hintChanged({});
}

bool MeasureTool::mousePress(SceneView& view, const QMouseEvent& event) {
    pressed_.reset();
    // Alt leaves the mouse to navigation, whatever lies under it.
    if (event.modifiers() & Qt::AltModifier) return false;
    pressed_ = event.pos();
    if (!first_ && aids_.mover.press(view, event)) return true;
    // The press also reaches navigation: only a release at the same place is a click.
    return false;
}

bool MeasureTool::mouseMove(SceneView& view, const QMouseEvent& event) {
    if (aids_.mover.move(view, event)) return true;
    if (event.buttons() != Qt::NoButton || (event.modifiers() & Qt::AltModifier)) {
        aids_.feedback.hide();
        if (event.buttons() == Qt::NoButton) return false;
    } else if (!first_) {
        aids_.mover.point(view, event.pos());
    }
    aids_.probe.hover(view, event);
    return false;
}

bool MeasureTool::mouseRelease(SceneView& view, const QMouseEvent& event) {
    const auto from = pressed_;
    pressed_.reset();
    if (aids_.mover.holding() && aids_.mover.release(view, event)) return true;
    if (!from || (event.pos() - *from).manhattanLength() >= QApplication::startDragDistance()) return false;
    if (event.button() == Qt::LeftButton) click(view, event.pos());
    if (event.button() == Qt::RightButton) {
        if (first_)
            abandon();
        else
            emit finished();
    }
    return false;
}

bool MeasureTool::mouseDoubleClick(SceneView&, const QMouseEvent& event) {
    pressed_.reset();
    if (event.button() == Qt::LeftButton && completing_ && !first_) emit finished();
    return true;
}

bool MeasureTool::keyPress(SceneView& view, const QKeyEvent& event) {
    if (!first_ && aids_.mover.keyPress(view, event)) {
        // The release that follows a drag that was given up is no click.
        pressed_.reset();
        return true;
    }
    if (event.key() != Qt::Key_Escape) return false;
    if (first_)
        abandon();
    else
        emit finished();
    return true;
}

bool MeasureTool::holdsKey(const SceneView&, const QKeyEvent& event) const {
    return aids_.mover.holdsKey(event) || (event.key() == Qt::Key_Escape && first_);
}

void MeasureTool::paint(const SceneView&, QPainter& painter, const ViewCamera& camera,
                        const ViewTheme& theme) const {
    aids_.mover.paint(painter, camera, theme, !first_);
    aids_.feedback.paint(painter, camera, theme);
}

void MeasureTool::click(SceneView& view, const QPoint& position) {
    aids_.probe.take(view, position, [this, asked = abandoned_](const ProbedPlace& place) {
        if (asked == abandoned_) take(place);
    });
}

void MeasureTool::take(const ProbedPlace& place) {
    problem_ = place.problem;
    completing_ = place.pick && first_;
    if (!place.pick) {
        aids_.feedback.show(*view_, place);
        return tellHint();
    }
    if (first_ && first_->place() == place.pick->place()) {
        completing_ = false;
        problem_ = tr("that is the first end: click the other one");
        return tellHint();
    }
    if (first_)
        complete(*place.pick);
    else
        first_ = place.pick;
    aids_.feedback.hide();
    showPending(std::nullopt);
    tellHint();
}

const Measurement* MeasureTool::again() const {
    const Measurement* selected = document_.state().measurement(selection_.object());
    return selected && kindSpec(selected->kind).isPair() ? selected : nullptr;
}

void MeasureTool::complete(const ProbedPick& second) {
    const PickedPair pair{first_->point, second.point};
    first_.reset();
    const Measurement* selected = again();
    const bool created = selected == nullptr;
    std::string object = created ? std::string() : selected->object;
    if (created) object = freeObjectName(document_.state());
    if (created) {
        document_.begin(QString::fromStdString("pick " + object + ", repeat 1"));
        Measurement fresh;
        fresh.object = object;
        document_.perform(setMeasurement(std::move(fresh), "add " + object));
    }
    document_.perform(addPick(object, pair.a.layer, pair));
    if (created) document_.end();
    const std::string method = methodOfKey(document_.state(), pair.a.layer);
    selection_.setMethod(pair.a.fitted || pair.b.fitted ? fittedMethod(method) : method);
    selection_.setObject(object);
    const auto& held = document_.state().measurement(object)->picks;
    if (const auto pairs = held.find(pair.a.layer); pairs != held.end())
        last_ = PickHandle{object, pair.a.layer, pairs->second.size() - 1, 1, false};
    aids_.mover.select(last_);
    if (created) emit objectCreated(object);
}

void MeasureTool::abandon() {
    ++abandoned_;
    first_.reset();
    problem_.clear();
    showPending(std::nullopt);
    tellHint();
}

void MeasureTool::show(const ProbedPlace& place) {
    if (!view_ || aids_.mover.moving()) return;
    aids_.feedback.show(*view_, place);
    showPending(place.pick ? std::optional(place.pick->place()) : std::nullopt);
    // Free space is no problem until it is clicked.
    const QString problem = place.under && !place.fitting ? place.problem : QString();
    if (problem == problem_) return;
    problem_ = problem;
    tellHint();
}

void MeasureTool::showPending(const std::optional<Eigen::Vector3d>& under) {
    if (!view_) return;
    if (!first_) return view_->setPendingMark(std::nullopt);
    ViewMark mark{first_->place(), first_->place(), {}, true};
    if (under) {
        mark.b = *under;
        mark.label = lengthText((mark.b - mark.a).norm()).toStdString() + " m";
    }
    view_->setPendingMark(mark);
}

void MeasureTool::tellHint() {
    if (!view_) return;
    const Measurement* object = again();
    const QString name = object ? QString::fromStdString(object->object) : tr("New object");
    const std::size_t done = object ? pickCount(*object, document_.state(), selection_.method()) : 0;
    const QString repeat = done < 3 ? tr("repeat %1 of 3").arg(done + 1) : tr("repeat %1").arg(done + 1);
    const QString taken = snapPhrase(aids_.choices.snap());
    const QString step = first_ ? tr("click the second end %1, Esc gives up").arg(taken)
                                : tr("click the first end %1").arg(taken);
    QString hint = tr("%1, %2: %3").arg(name, repeat, step);
    // Whoever aims at the second end should not know what would fit the other repeats.
    QString below = problem_;
    if (below.isEmpty() && !first_) below = repeatNoiseText(document_.state(), selection_, last_);
    // A line that comes and goes under the cursor would move what stands beside it.
    if (below.isEmpty() && aids_.choices.snap() != SnapMode::point)
        below = tr("What is found is drawn before the click. N: the next kind of snap.");
    if (!below.isEmpty()) hint += '\n' + below;
    emit hintChanged(hint);
}

}  // namespace vestige
