#include "ui/tools/PathTool.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWidget>
#include <algorithm>

#include "core/measurement/kinds/KindSpec.h"
#include "core/scene/Edits.h"
#include "core/scene/KindEdits.h"
#include "core/scene/MeasuredScene.h"
#include "ui/document/Document.h"
#include "ui/document/Notices.h"
#include "ui/document/ObjectNames.h"
#include "ui/document/PickChoices.h"
#include "ui/document/Selection.h"
#include "ui/document/Wording.h"
#include "ui/tools/PickFeedback.h"
#include "ui/tools/PickMover.h"
#include "ui/tools/PickProbe.h"
#include "ui/tools/PickWords.h"
#include "ui/view/PendingPath.h"
#include "ui/view/SceneView.h"

namespace vestige {

PathTool::PathTool(Document& document, Selection& selection, Notices& notices, const PickAids& aids,
                   QObject* parent)
    : QObject(parent), document_(document), selection_(selection), notices_(notices), aids_(aids) {
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

const KindSpec& PathTool::spec() const {
    return kindSpec(kind_);
}

const Measurement* PathTool::again() const {
    const Measurement* selected = document_.state().measurement(selection_.object());
    return selected && selected->kind == kind_ ? selected : nullptr;
}

void PathTool::setKind(MeasurementKind kind) {
    abandon();
    kind_ = kind;
    tellHint();
}

void PathTool::enter(SceneView& view) {
    view_ = &view;
    view.widget()->setCursor(Qt::CrossCursor);
    view.widget()->setFocus();
    problem_.clear();
    tellHint();
    view.updateOverlay();
}

void PathTool::leave(SceneView& view) {
    abandon();
    aids_.mover.leave(view);
    aids_.probe.stop();
    aids_.feedback.hide();
    view.widget()->unsetCursor();
    view.updateOverlay();
    view_ = nullptr;
    emit hintChanged({});
}

bool PathTool::mousePress(SceneView& view, const QMouseEvent& event) {
    pressed_.reset();
    // Alt leaves the mouse to navigation, whatever lies under it.
    if (event.modifiers() & Qt::AltModifier) return false;
    pressed_ = event.pos();
    if (!begun() && aids_.mover.press(view, event)) return true;
    // The press also reaches navigation: only a release at the same place is a click.
    return false;
}

bool PathTool::mouseMove(SceneView& view, const QMouseEvent& event) {
    if (aids_.mover.move(view, event)) return true;
    if (event.buttons() != Qt::NoButton || (event.modifiers() & Qt::AltModifier)) {
        aids_.feedback.hide();
        if (event.buttons() == Qt::NoButton) return false;
    } else if (!begun()) {
        aids_.mover.point(view, event.pos());
    }
    aids_.probe.hover(view, event);
    return false;
}

bool PathTool::mouseRelease(SceneView& view, const QMouseEvent& event) {
    const auto from = pressed_;
    pressed_.reset();
    if (aids_.mover.holding() && aids_.mover.release(view, event)) return true;
    if (!from || (event.pos() - *from).manhattanLength() >= QApplication::startDragDistance()) return false;
    if (event.button() == Qt::LeftButton) click(view, event.pos());
    if (event.button() == Qt::RightButton) {
        if (begun())
            finish();
        else
            emit finished();
    }
    return false;
}

bool PathTool::mouseDoubleClick(SceneView&, const QMouseEvent& event) {
    pressed_.reset();
    // The first of the two clicks has added its point.
    if (event.button() == Qt::LeftButton && begun()) finish();
    return true;
}

void PathTool::paint(const SceneView&, QPainter& painter, const ViewCamera& camera,
                     const ViewTheme& theme) const {
    std::vector<Eigen::Vector3d> path;
    for (const ProbedPick& point : points_) path.push_back(point.place());
    paintPendingPath(painter, theme, camera, path);
    aids_.mover.paint(painter, camera, theme, !begun());
    aids_.feedback.paint(painter, camera, theme);
}

bool PathTool::holdsKey(const SceneView&, const QKeyEvent& event) const {
    if (!begun()) return aids_.mover.holdsKey(event);
    const int key = event.key();
    return event.modifiers() == Qt::NoModifier && (key == Qt::Key_Escape || key == Qt::Key_Backspace ||
                                                   key == Qt::Key_Return || key == Qt::Key_Enter);
}

bool PathTool::keyPress(SceneView& view, const QKeyEvent& event) {
    if (!begun()) {
        if (aids_.mover.keyPress(view, event)) {
            // The release that follows a drag that was given up is no click.
            pressed_.reset();
            return true;
        }
        if (event.key() != Qt::Key_Escape) return false;
        emit finished();
        return true;
    }
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
    if (points_.size() >= kMostPathPoints)
        return notices_.inform(tr("A path has %1 points at most.").arg(kMostPathPoints));
    ++waiting_;
    aids_.probe.take(view, position, [this, asked = forgotten_](const ProbedPlace& place) {
        if (asked == forgotten_) take(place);
    });
}

void PathTool::take(const ProbedPlace& place) {
    --waiting_;
    problem_ = place.problem;
    if (!place.pick) {
        ending_ = false;
        aids_.feedback.show(*view_, place);
        return tellHint();
    }
    points_.push_back(*place.pick);
    aids_.feedback.hide();
    if (spec().most > 0 && points_.size() == spec().most) return complete();
    if (ending_ && waiting_ == 0) return finish();
    showPending(std::nullopt);
    tellHint();
}

void PathTool::finish() {
    // What was clicked last is still being fitted.
    ending_ = waiting_ > 0;
    if (ending_ || points_.empty()) return;
    if (points_.size() < spec().fewest)
        return notices_.inform(tr("This needs %1 points or more; there are %2. Esc gives up.")
                                   .arg(spec().fewest)
                                   .arg(points_.size()));
    complete();
}

void PathTool::complete() {
    PickedPath path;
    for (ProbedPick& point : points_) path.push_back(std::move(point.point));
    points_.clear();
    ending_ = false;
    const bool fitted =
        std::any_of(path.begin(), path.end(), [](const PickedPoint& p) { return p.fitted.has_value(); });
    const std::string key = path.front().layer;
    const std::size_t last = path.size() - 1;
    const Measurement* selected = again();
    const bool created = !selected;
    const std::string object =
        created ? freeObjectName(document_.state(), shortLabel(spec())) : selected->object;
    if (created) {
        document_.begin(tr("pick %1, repeat 1").arg(QString::fromStdString(object)));
        Measurement fresh;
        fresh.object = object;
        fresh.kind = kind_;
        document_.perform(setMeasurement(std::move(fresh), "add " + object));
    }
    const bool pair = spec().isPair();
    document_.perform(pair ? addPick(object, key, {path[0], path[1]})
                           : addPath(object, key, std::move(path)));
    if (created) document_.end();
    const std::string method = methodOfKey(document_.state(), key);
    selection_.setMethod(fitted ? fittedMethod(method) : method);
    selection_.setObject(object);
    // Repeats are added at the end of their own key.
    const Measurement& held = *document_.state().measurement(object);
    const auto repeats = [&](const auto& of) {
        const auto found = of.find(key);
        return found == of.end() ? std::size_t{0} : found->second.size();
    };
    if (const std::size_t count = pair ? repeats(held.picks) : repeats(held.paths); count > 0)
        aids_.mover.select(PickHandle{object, key, count - 1, last, !pair});
    showPending(std::nullopt);
    tellHint();
    if (created) emit objectCreated(object);
}

void PathTool::takeBack() {
    if (waiting_ > 0)
        forgetClicks();
    else
        points_.pop_back();
    showPending(std::nullopt);
    tellHint();
}

void PathTool::abandon() {
    forgetClicks();
    points_.clear();
    problem_.clear();
    showPending(std::nullopt);
    tellHint();
}

void PathTool::forgetClicks() {
    ++forgotten_;
    waiting_ = 0;
    ending_ = false;
}

void PathTool::show(const ProbedPlace& place) {
    if (!view_ || aids_.mover.moving()) return;
    aids_.feedback.show(*view_, place);
    showPending(place.pick ? std::optional(place.pick->place()) : std::nullopt);
    // Free space is no problem until it is clicked.
    const QString problem = place.under && !place.fitting ? place.problem : QString();
    if (problem == problem_) return;
    problem_ = problem;
    tellHint();
}

void PathTool::showPending(const std::optional<Eigen::Vector3d>& under) {
    if (!view_) return;
    view_->updateOverlay();
    if (points_.empty() || !under) return view_->setPendingMark(std::nullopt);
    ViewMark mark{points_.back().place(), *under, {}, true};
    mark.label = lengthText((mark.b - mark.a).norm()).toStdString() + " m";
    view_->setPendingMark(mark);
}

void PathTool::tellHint() {
    if (!view_) return;
    const Measurement* object = again();
    const QString name =
        object ? QString::fromStdString(object->object) : tr("New: %1").arg(said(spec().label));
    const std::size_t done = object ? pickCount(*object, document_.state(), selection_.method()) : 0;
    const QString repeat = done < 3 ? tr("repeat %1 of 3").arg(done + 1) : tr("repeat %1").arg(done + 1);
    const std::map<std::string, double> settings =
        object ? object->settings : std::map<std::string, double>();
    QString step =
        tr("click %1 %2")
            .arg(said(pickName(spec(), settings, points_.size())), snapPhrase(aids_.choices.snap()));
    if (begun()) {
        if (spec().most != spec().fewest && points_.size() >= spec().fewest)
            step += tr("; double click or Enter ends");
        step += tr("; Backspace takes the last point back, Esc gives up");
    }
    emit hintChanged(tr("%1, %2: %3").arg(name, repeat, step) + '\n' + below());
}

/// The second line of the hint. It is never empty: one that comes and goes under the cursor would move what
/// stands beside it.
QString PathTool::below() const {
    if (!problem_.isEmpty()) return problem_;
    if (!begun())
        if (const QString noise = figureNoiseText(document_.measured(), selection_);
            again() && !noise.isEmpty())
            return noise;
    const Measurement* object = again();
    const QString advice =
        said(pickAdvice(spec(), object ? object->settings : std::map<std::string, double>()));
    if (!advice.isEmpty()) return advice;
    if (aids_.choices.snap() == SnapMode::point)
        return tr("N: the next kind of snap, such as an edge or a corner.");
    return tr("What is found is drawn before the click. N: the next kind of snap.");
}

}  // namespace vestige
