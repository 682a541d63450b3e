#include "ui/tools/CompareTool.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWidget>
#include <cmath>

#include "ui/document/Comparison.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {
constexpr double kReach_px = 8;
constexpr double kHandle_px = 16;
}  // namespace

CompareTool::CompareTool(Comparison& comparison, QObject* parent)
    : QObject(parent), comparison_(comparison) {}

bool CompareTool::onDivider(const SceneView& view, const QMouseEvent& event) const {
    if (comparison_.mode() != CompareMode::swipe) return false;
    const ViewCamera camera = view.camera();
    const double off = std::abs(event.x() + 0.5 - comparison_.shown().divider * camera.width_px);
    const bool atHandle = std::abs(event.y() + 0.5 - 0.5 * camera.height_px) <= kHandle_px;
    return off <= (atHandle ? kHandle_px : kReach_px);
}

bool CompareTool::mousePress(SceneView& view, const QMouseEvent& event) {
    dragging_ = event.button() == Qt::LeftButton && onDivider(view, event);
    return dragging_;
}

bool CompareTool::mouseMove(SceneView& view, const QMouseEvent& event) {
    if (dragging_) {
        comparison_.setDivider((event.x() + 0.5) / std::max(1, view.camera().width_px));
        return true;
    }
    const bool over = event.buttons() == Qt::NoButton && onDivider(view, event);
    if (over != pointing_) {
        pointing_ = over;
        if (over) before_ = view.widget()->cursor();
        view.widget()->setCursor(over ? QCursor(Qt::SplitHCursor) : before_);
    }
    return over;
}

bool CompareTool::mouseRelease(SceneView&, const QMouseEvent& event) {
    if (!dragging_ || event.button() != Qt::LeftButton) return false;
    dragging_ = false;
    return true;
}

bool CompareTool::keyPress(SceneView&, const QKeyEvent& event) {
    if (!comparison_.active()) return false;
    switch (event.key()) {
        case Qt::Key_Left:
            comparison_.step(-1);
            return true;
        case Qt::Key_Right:
            comparison_.step(1);
            return true;
        case Qt::Key_Space:
            comparison_.toggleHeld();
            return true;
        default:
            return false;
    }
}

}  // namespace vestige
