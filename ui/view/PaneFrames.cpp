#include "ui/view/PaneFrames.h"

#include "ui/watch/WatchedTime.h"

#include <QElapsedTimer>
#include <QWidget>
#include <algorithm>

namespace vestige {
namespace {

constexpr double kMovingFrame_s = 0.07;
constexpr double kRestingFrame_s = 0.12;
/// A picture is complete after so many steps at most, once the graphics card holds its points: each step
/// costs light and copying, too, however few its points.
constexpr double kLeastStep = 1.0 / 12;
constexpr int kRest_ms = 160;
/// Points made ready and given to the graphics card between two frames: about 30 ms on two cores.
constexpr std::size_t kBroughtAtOnce = 400000;

}  // namespace

PaneFrames::PaneFrames(std::unique_ptr<ViewSurface> surface, std::function<void()> drawn)
    : surface_(std::move(surface)),
      drawing_(std::make_unique<SceneDrawing>(surface_->renderWindow())),
      drawn_(std::move(drawn)),
      movingBudget_(kMovingFrame_s),
      restingBudget_(kRestingFrame_s) {
    frameTimer_.setSingleShot(true);
    restTimer_.setSingleShot(true);
    QObject::connect(&frameTimer_, &QTimer::timeout, [this] { frame(); });
    QObject::connect(&restTimer_, &QTimer::timeout, [this] { rest(); });
}

PaneFrames::~PaneFrames() = default;

void PaneFrames::start() {
    if (!frameTimer_.isActive()) frameTimer_.start(0);
}

void PaneFrames::sceneChanged() {
    sceneChanged_ = true;
    allChanged();
}

void PaneFrames::sizeChanged() {
    panes_.fit(widget()->size());
    drawing_->setPanes(panes_.viewports(widget()->size()));
    allChanged();
}

void PaneFrames::layoutChanged() {
    movingPane_.reset();
    sizeChanged();
    // A new pane's background and light are those of the scene.
    sceneChanged_ = true;
}

void PaneFrames::paneChanged(ViewPane& pane) {
    pane.changed = true;
    start();
}

void PaneFrames::allChanged() {
    for (ViewPane& pane : panes_.all()) pane.changed = true;
    start();
}

void PaneFrames::moves(const ViewPane* pane) {
    moving_ = true;
    movingPane_.reset();
    for (std::size_t i = 0; pane && i < panes_.all().size(); ++i)
        if (&panes_.all()[i] == pane) movingPane_ = i;
    restTimer_.start(kRest_ms);
}

void PaneFrames::mixChanged() {
    for (std::size_t i = 0; i < panes_.all().size() && !sceneChanged_; ++i) {
        const ViewPane& pane = panes_.all()[i];
        if (pane.changed) continue;
        drawing_->usePane(i);
        drawing_->addToPicture(pane.share);
        const DrawingTime watched;
        surface_->drawFrame();
    }
}

/// While something moves, only what moves and what has no picture of it yet.
std::optional<std::size_t> PaneFrames::nextPane() const {
    const std::vector<ViewPane>& all = panes_.all();
    if (moving_ && movingPane_ && *movingPane_ < all.size() && all[*movingPane_].changed) return movingPane_;
    for (const bool activeOnly : {true, false})
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (activeOnly && i != panes_.activeIndex()) continue;
            if (all[i].changed || (!moving_ && all[i].share < 1)) return i;
        }
    return std::nullopt;
}

void PaneFrames::frame() {
    if (const auto pane = nextPane()) step(*pane, false);
    if (nextPane()) start();
}

/// Draws the next step of a pane's picture: the first points, or some more. `all` leaves nothing out.
void PaneFrames::step(std::size_t index, bool all) {
    if (widget()->size().isEmpty()) return;
    panes_.fit(widget()->size());
    if (sceneChanged_) {
        drawing_->show(description());
        for (ViewPane& pane : panes_.all()) pane.changed = true;
    }
    ViewPane& pane = panes_.all()[index];
    drawing_->usePane(index);
    const bool begin = pane.changed;
    if (begin) drawing_->setCamera(pane.camera);
    const std::size_t wanted = drawing_->pointsWanted();
    const bool passes = moving_ && begin && !all;
    FrameBudget& budget = moving_ ? movingBudget_ : restingBudget_;
    double part =
        wanted == 0 || all ? 1.0 : static_cast<double>(budget.points()) / static_cast<double>(wanted);
    // Panes that move together share the time of a frame.
    if (passes && !movingPane_) part /= static_cast<double>(panes_.all().size());
    if (!moving_) part = std::max(part, kLeastStep);
    const double from = begin ? 0 : pane.share;
    double to = std::min(1.0, from + part);
    if (!all && !passes) to = drawing_->shareWithin(from, to, kBroughtAtOnce);
    bool holds = true;
    QElapsedTimer whole;
    whole.start();
    if (passes)
        holds = drawing_->beginPassingPicture(to, kBroughtAtOnce);
    else if (begin)
        drawing_->beginPicture(to);
    else
        drawing_->addToPicture(to);
    QElapsedTimer clock;
    clock.start();
    const bool drawn = [&] {
        const DrawingTime watched;
        return surface_->drawFrame();
    }();
    if (!drawn) {
        frameTimer_.start(20);
        return;
    }
    budget.frameTook(static_cast<std::size_t>((to - from) * static_cast<double>(wanted)),
                     1e-9 * static_cast<double>(clock.nsecsElapsed()));
    if (passes) movingFrame_s_ = 1e-9 * static_cast<double>(whole.nsecsElapsed());
    if (begin) pane.lacks = !holds;
    pane.atOnce = begin;
    sceneChanged_ = pane.changed = false;
    pane.share = to;
    drawn_();
}

/// Nothing moves any more: what was left out of passing pictures comes in.
void PaneFrames::rest() {
    moving_ = false;
    for (ViewPane& pane : panes_.all())
        if (pane.lacks) pane.changed = true;
    frameTimer_.start(0);
}

void PaneFrames::completePicture() {
    moving_ = false;
    for (std::size_t i = 0; i < panes_.all().size(); ++i) {
        ViewPane& pane = panes_.all()[i];
        if (!sceneChanged_ && pane.isComplete() && pane.atOnce) continue;
        // Points of equal depth hide each other by the order of drawing, and steps end where the time of a
        // frame did: what they drew is drawn anew.
        pane.changed = true;
        step(i, true);
    }
}

bool PaneFrames::isComplete() const {
    return !sceneChanged_ && std::all_of(panes_.all().begin(), panes_.all().end(),
                                         [](const ViewPane& pane) { return pane.isComplete(); });
}

}  // namespace vestige
