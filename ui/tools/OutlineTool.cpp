#include "ui/tools/OutlineTool.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>

#include "ui/tools/OutlineOverlay.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {

constexpr int kStrokeStep_px = 3;
constexpr int kOnCorner_px = 8;
/// Corners of a stroke are too many to mark.
constexpr std::size_t kMostMarked = 60;

}  // namespace

OutlineTool::OutlineTool(Shape shape, HoverProbe& probe, QObject* parent)
    : QObject(parent), shape_(shape), probe_(probe) {}

OutlineTool::~OutlineTool() {
    delete overlay_;
}

void OutlineTool::enter(SceneView& view) {
    view_ = &view;
    view.widget()->setCursor(Qt::CrossCursor);
    view.widget()->installEventFilter(this);
    overlay_ = new OutlineOverlay(view.widget());
    connect(overlay_, &QObject::destroyed, this, [this] { overlay_ = nullptr; });
    show();
}

void OutlineTool::leave(SceneView& view) {
    corners_.clear();
    cursor_.reset();
    pressed_.reset();
    stroke_ = began_ = passing_ = false;
    probe_.stop();
    view.widget()->removeEventFilter(this);
    view.widget()->unsetCursor();
    delete overlay_;
    view_ = nullptr;
    emit hintChanged({});
}

/// Keys that mean something to an outline are not shortcuts while there is one.
bool OutlineTool::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && !corners_.empty()) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Backspace || key == Qt::Key_Escape || key == Qt::Key_Return ||
            key == Qt::Key_Enter)
            event->accept();
    }
    return QObject::eventFilter(watched, event);
}

bool OutlineTool::mousePress(SceneView&, const QMouseEvent& event) {
    passing_ = (event.modifiers() & Qt::AltModifier) || event.button() == Qt::MiddleButton ||
               (event.button() == Qt::RightButton && corners_.empty());
    if (passing_) return false;
    if (event.button() != Qt::LeftButton) return true;
    pressed_ = event.pos();
    began_ = corners_.empty();
    if (began_) add(event.pos());
    return true;
}

bool OutlineTool::mouseMove(SceneView& view, const QMouseEvent& event) {
    if (passing_ && event.buttons() != Qt::NoButton) return false;
    probe_.moved(view, event);
    if (corners_.empty()) return false;
    cursor_ = event.pos();
    const bool down = pressed_ && (event.buttons() & Qt::LeftButton);
    if (down && !stroke_)
        stroke_ = (event.pos() - *pressed_).manhattanLength() >= QApplication::startDragDistance();
    if (down && stroke_ && shape_ == Shape::lasso &&
        (event.pos() - corners_.back()).manhattanLength() >= kStrokeStep_px)
        corners_.push_back(event.pos());
    show();
    return true;
}

bool OutlineTool::mouseRelease(SceneView&, const QMouseEvent& event) {
    if (passing_) {
        passing_ = false;
        return false;
    }
    if (event.button() == Qt::RightButton) {
        close(event.modifiers());
        return true;
    }
    if (!pressed_) return true;
    pressed_.reset();
    cursor_ = event.pos();
    const bool drawn = std::exchange(stroke_, false);
    const bool began = std::exchange(began_, false);
    if (shape_ == Shape::box) {
        if (drawn || !began) close(event.modifiers());
    } else if (drawn) {
        if (began) close(event.modifiers());
    } else if (!began) {
        if (onFirst(event.pos()))
            close(event.modifiers());
        else
            add(event.pos());
    }
    show();
    return true;
}

bool OutlineTool::mouseDoubleClick(SceneView&, const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton || corners_.empty()) return false;
    // The first of the two clicks has set the corner already.
    pressed_.reset();
    close(event.modifiers());
    return true;
}

bool OutlineTool::keyPress(SceneView&, const QKeyEvent& event) {
    if (corners_.empty()) return false;
    switch (event.key()) {
        case Qt::Key_Escape:
            abandon();
            return true;
        case Qt::Key_Backspace:
            takeBack();
            return true;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            close(event.modifiers() & ~Qt::KeypadModifier);
            return true;
        default:
            return false;
    }
}

void OutlineTool::abandon() {
    corners_.clear();
    cursor_.reset();
    pressed_.reset();
    stroke_ = began_ = false;
    show();
}

void OutlineTool::add(const QPoint& place) {
    corners_.push_back(place);
    cursor_ = place;
    show();
}

void OutlineTool::takeBack() {
    corners_.pop_back();
    if (corners_.empty()) cursor_.reset();
    show();
}

bool OutlineTool::onFirst(const QPoint& place) const {
    return corners_.size() >= 3 && (place - corners_.front()).manhattanLength() <= kOnCorner_px;
}

std::vector<QPoint> OutlineTool::outline() const {
    if (shape_ == Shape::lasso || corners_.empty() || !cursor_) return corners_;
    const QPoint a = corners_.front();
    return {a, {cursor_->x(), a.y()}, *cursor_, {a.x(), cursor_->y()}};
}

void OutlineTool::close(Qt::KeyboardModifiers modifiers) {
    std::vector<Eigen::Vector2d> places;
    for (const QPoint& corner : outline()) places.emplace_back(corner.x() + 0.5, corner.y() + 0.5);
    abandon();
    if (places.size() >= 3) emit closed(places, modifiers);
}

void OutlineTool::show() {
    if (!view_) return;
    std::vector<QPoint> shown = outline();
    const std::size_t marked = corners_.size() <= kMostMarked ? shown.size() : 1;
    if (shape_ == Shape::lasso && cursor_ && !shown.empty() && !stroke_) shown.push_back(*cursor_);
    if (overlay_) overlay_->show(std::move(shown), marked);
    if (shape_ == Shape::box)
        emit hintChanged(
            corners_.empty()
                ? tr("Drag a box round points. Shift adds, Ctrl takes away; Alt+drag turns the view")
                : tr("Let go, or click the opposite corner; Esc gives up"));
    else if (corners_.empty())
        emit hintChanged(tr(
            "Click round points, or draw round them. Shift adds, Ctrl takes away; Alt+drag turns the view"));
    else
        emit hintChanged(tr("%1 corners: double-click, Return or right-click closes, Backspace takes one "
                            "back, Esc gives up")
                             .arg(corners_.size()));
}

}  // namespace vestige
