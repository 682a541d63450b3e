#include "ui/tools/PickMover.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWidget>
#include <cmath>

#include "core/scene/Edits.h"
#include "core/scene/KindEdits.h"
#include "core/scene/PickFrame.h"
#include "ui/document/Document.h"
#include "ui/document/ObjectNames.h"
#include "ui/document/Selection.h"
#include "ui/document/Wording.h"
#include "ui/tools/PickFeedback.h"
#include "ui/tools/PickProbe.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {

/// From the last key on; what was nudged then enters the case as one step.
constexpr int kNudge_ms = 800;

std::optional<QPoint> stepOf(const QKeyEvent& event) {
    if (event.modifiers() & ~Qt::KeypadModifier) return std::nullopt;
    switch (event.key()) {
        case Qt::Key_Left:
            return QPoint(-1, 0);
        case Qt::Key_Right:
            return QPoint(1, 0);
        case Qt::Key_Up:
            return QPoint(0, -1);
        case Qt::Key_Down:
            return QPoint(0, 1);
        default:
            return std::nullopt;
    }
}

std::optional<QPoint> pixelOf(const SceneView& view, const Eigen::Vector3d& world) {
    const auto seen = view.camera().project(world);
    if (!seen || seen->pixel.cwiseAbs().maxCoeff() > 1e6) return std::nullopt;
    return QPoint(static_cast<int>(std::floor(seen->pixel.x())),
                  static_cast<int>(std::floor(seen->pixel.y())));
}

}  // namespace

PickMover::PickMover(Document& document, Selection& selection, PickProbe& probe, PickFeedback& feedback,
                     QObject* parent)
    : QObject(parent), document_(document), selection_(selection), probe_(probe), feedback_(feedback) {
    nudgeTimer_.setSingleShot(true);
    nudgeTimer_.setInterval(kNudge_ms);
    connect(&nudgeTimer_, &QTimer::timeout, this, [this] { endNudge(); });
    connect(&document_, &Document::changed, this, [this] { follow(); });
    connect(&selection_, &Selection::changed, this, [this] { follow(); });
}

bool PickMover::point(SceneView& view, const QPoint& position) {
    const auto under = handleAt(document_.state(), selection_, view.camera(), QPointF(position));
    if (under == pointed_) return under.has_value();
    if (under && !pointed_) before_ = view.widget()->cursor();
    if (under)
        view.widget()->setCursor(Qt::OpenHandCursor);
    else
        view.widget()->setCursor(before_);
    pointed_ = under;
    view.updateOverlay();
    return under.has_value();
}

bool PickMover::press(SceneView& view, const QMouseEvent& event) {
    endNudge();
    if (event.button() != Qt::LeftButton || (event.modifiers() & Qt::AltModifier)) return false;
    const auto handle = handleAt(document_.state(), selection_, view.camera(), QPointF(event.pos()));
    if (!handle) return false;
    const auto aim = aimOf(view, *handle);
    if (!aim) return false;
    held_ = Held{*handle, event.pos(), *aim - event.pos()};
    return true;
}

bool PickMover::move(SceneView& view, const QMouseEvent& event) {
    if (!held_) return false;
    if (!(event.buttons() & Qt::LeftButton)) {
        giveUp(view);
        return false;
    }
    if (!held_->dragging &&
        (event.pos() - held_->pressed).manhattanLength() < QApplication::startDragDistance())
        return true;
    if (!held_->dragging) view.widget()->setCursor(Qt::ClosedHandCursor);
    held_->dragging = true;
    active_ = held_->handle;
    probe_.follow(view, event.pos() + held_->offset,
                  [this, &view, handle = held_->handle](const auto& place) {
                      if (held_) propose(view, handle, place);
                  });
    return true;
}

bool PickMover::release(SceneView& view, const QMouseEvent& event) {
    if (!held_ || event.button() != Qt::LeftButton) return false;
    const Held held = *held_;
    held_.reset();
    active_ = held.handle;
    view.updateOverlay();
    if (!held.dragging) return false;
    view.widget()->setCursor(Qt::OpenHandCursor);
    probe_.take(view, event.pos() + held.offset,
                [this, &view, handle = held.handle](const auto& place) { finish(view, handle, place); });
    return true;
}

bool PickMover::keyPress(SceneView& view, const QKeyEvent& event) {
    if (event.key() == Qt::Key_Escape && moving()) {
        giveUp(view);
        return true;
    }
    // The keys move the divider of a comparison.
    const auto step = view.description().comparison ? std::nullopt : stepOf(event);
    return step && nudge(view, *step);
}

bool PickMover::holdsKey(const QKeyEvent& event) const {
    return event.key() == Qt::Key_Escape && moving();
}

void PickMover::select(std::optional<PickHandle> handle) {
    endNudge();
    active_ = std::move(handle);
}

void PickMover::leave(SceneView& view) {
    endNudge();
    if (nudge_) {
        // No more answers come from here on: what the keys had come to counts.
        const Nudge done = *nudge_;
        nudge_.reset();
        withdraw(view);
        if (done.last) finish(view, done.handle, *done.last);
    }
    if (held_) giveUp(view);
    pointed_.reset();
    active_.reset();
}

void PickMover::paint(QPainter& painter, const ViewCamera& camera, const ViewTheme& theme,
                      bool handles) const {
    paintRepeats(painter, theme, camera, document_.state(), selection_,
                 {handles, pointed_, active_, proposed_});
}

/// The pixel that a click for the point as it is would aim at: where its measured point is seen, but for a
/// surface's end, which lies on the line of sight itself.
std::optional<QPoint> PickMover::aimOf(const SceneView& view, const PickHandle& handle) const {
    const PickedPoint* point = pointOf(document_.state(), handle);
    if (!point) return std::nullopt;
    PickedPoint aimed = *point;
    if (aimed.fitted && aimed.fitted->mode == SnapMode::surface) aimed.position = aimed.fitted->position;
    return pixelOf(view, scenePosition(document_.state(), aimed));
}

/// Why the end cannot go to that place; empty when it can.
QString PickMover::refusal(const PickHandle& handle, const ProbedPlace& place) const {
    if (!place.pick) return place.problem;
    const SceneState& scene = document_.state();
    const std::string method = methodOfKey(scene, place.pick->point.layer);
    const std::string counts = methodOfKey(scene, handle.key);
    if (method == counts) return {};
    return tr("This repeat counts for %1, the point here for %2: measure it as a repeat of its own.")
        .arg(QString::fromStdString(counts), QString::fromStdString(method));
}

void PickMover::propose(SceneView& view, const PickHandle& handle, const ProbedPlace& place) {
    feedback_.show(view, place);
    const SceneState& scene = document_.state();
    const PickedPoint* point = pointOf(scene, handle);
    const PickedPoint* other = neighbourOf(scene, handle);
    if (!point || !other) return;
    const QString problem = refusal(handle, place);
    if (!problem.isEmpty()) {
        withdraw(view);
        emit told(problem);
        return;
    }
    const Eigen::Vector3d fixed = measuredPlace(scene, *other, selection_.method());
    const Eigen::Vector3d from = measuredPlace(scene, *point, selection_.method());
    const double before_m = (from - fixed).norm();
    const double now_m = (place.pick->place() - fixed).norm();
    const QString length = lengthText(now_m) + " m";
    proposed_ = place.pick->place();
    view.setPendingMark(ViewMark{fixed, place.pick->place(), length.toStdString(), true});
    if (handle.ofPath)
        emit told(tr("Moving point %1 of repeat %2: %3 m from where it was. Esc puts it back.")
                      .arg(handle.place + 1)
                      .arg(handle.repeat + 1)
                      .arg(lengthText((place.pick->place() - from).norm())));
    else
        emit told(tr("Moving an end of repeat %1: %2, was %3 m. Esc puts it back.")
                      .arg(handle.repeat + 1)
                      .arg(length, lengthText(before_m)));
}

/// Nothing is proposed any longer.
void PickMover::withdraw(SceneView& view) {
    proposed_.reset();
    view.setPendingMark(std::nullopt);
}

void PickMover::finish(SceneView& view, const PickHandle& handle, const ProbedPlace& place) {
    withdraw(view);
    const QString problem = refusal(handle, place);
    emit told(problem);
    if (!problem.isEmpty()) return;
    const PickedPoint& point = place.pick->point;
    if (handle.ofPath)
        document_.perform(movePathPoint(handle.object, handle.key, handle.repeat, handle.place, point));
    else
        document_.perform(movePick(handle.object, handle.key, handle.repeat, handle.place == 1, point));
}

bool PickMover::nudge(SceneView& view, const QPoint& step) {
    if (!active_ || held_) return false;
    if (nudge_ && nudge_->ending) return true;
    const QSize size = view.widget()->size();
    if (!nudge_) {
        const auto aim = aimOf(view, *active_);
        if (!aim) return false;
        nudge_ = Nudge{*active_, *aim, size, 0, std::nullopt, false};
        nudgedIn_ = &view;
        // What the keys aim at are pixels of this camera.
        connect(&view, &SceneView::cameraChanged, this, &PickMover::endNudge, Qt::UniqueConnection);
    } else if (nudge_->size != size) {
        // The view has got another size under the same camera.
        if (nudge_->last && nudge_->last->under)
            if (const auto aim = pixelOf(view, nudge_->last->under->world)) nudge_->aim = *aim;
        nudge_->size = size;
    }
    nudge_->aim += step;
    ++nudge_->asked;
    nudgeTimer_.start();
    probe_.take(view, nudge_->aim, [this, &view](const ProbedPlace& place) {
        if (!nudge_) return;
        --nudge_->asked;
        nudge_->last = place;
        propose(view, nudge_->handle, place);
        if (nudge_->ending) endNudge();
    });
    return true;
}

void PickMover::endNudge() {
    nudgeTimer_.stop();
    if (!nudge_) return;
    nudge_->ending = true;
    if (nudge_->asked > 0) return;
    const Nudge done = *nudge_;
    nudge_.reset();
    feedback_.hide();
    finish(*nudgedIn_, done.handle, *done.last);
}

void PickMover::giveUp(SceneView& view) {
    nudgeTimer_.stop();
    nudge_.reset();
    if (held_) view.widget()->setCursor(before_);
    held_.reset();
    pointed_.reset();
    probe_.stop();
    feedback_.hide();
    withdraw(view);
    emit told({});
}

/// Handles of what is no longer there, or no longer selected, are let go.
void PickMover::follow() {
    const auto gone = [this](const PickHandle& handle) {
        return handle.object != selection_.object() || !pointOf(document_.state(), handle);
    };
    if (active_ && gone(*active_)) active_.reset();
    if (pointed_ && gone(*pointed_)) pointed_.reset();
    if (nudge_ && gone(nudge_->handle)) {
        nudge_.reset();
        nudgeTimer_.stop();
        withdraw(*nudgedIn_);
    }
}

}  // namespace vestige
