#include "ui/tools/OrbitTool.h"

#include <QMouseEvent>

#include "ui/view/SceneView.h"

namespace vestige {

bool OrbitTool::mouseDoubleClick(SceneView& view, const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return false;
    view.setPivotAt(event.pos());
    return true;
}

}  // namespace vestige
