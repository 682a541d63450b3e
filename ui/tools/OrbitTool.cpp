#include "ui/tools/OrbitTool.h"

#include <QMouseEvent>

#include "ui/document/PickChoices.h"
#include "ui/tools/PickMover.h"
#include "ui/view/SceneView.h"

namespace vestige {

void OrbitTool::leave(SceneView& view) {
    mover_.leave(view);
    probe_.stop();
    view.widget()->unsetCursor();
}

bool OrbitTool::mousePress(SceneView& view, const QMouseEvent& event) {
    return choices_.movable() && mover_.press(view, event);
}

bool OrbitTool::mouseMove(SceneView& view, const QMouseEvent& event) {
    if (mover_.move(view, event)) return true;
    if (choices_.movable() && event.buttons() == Qt::NoButton) mover_.point(view, event.pos());
    probe_.moved(view, event);
    return false;
}

bool OrbitTool::mouseRelease(SceneView& view, const QMouseEvent& event) {
    return mover_.holding() && mover_.release(view, event);
}

bool OrbitTool::keyPress(SceneView& view, const QKeyEvent& event) {
    return choices_.movable() && mover_.keyPress(view, event);
}

bool OrbitTool::holdsKey(const SceneView&, const QKeyEvent& event) const {
    return mover_.holdsKey(event);
}

void OrbitTool::paint(const SceneView&, QPainter& painter, const ViewCamera& camera,
                      const ViewTheme& theme) const {
    mover_.paint(painter, camera, theme, choices_.movable());
}

bool OrbitTool::mouseDoubleClick(SceneView& view, const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return false;
    view.setPivotAt(event.pos());
    return true;
}

}  // namespace vestige
