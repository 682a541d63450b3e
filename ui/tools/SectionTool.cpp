#include "ui/tools/SectionTool.h"

#include <QMouseEvent>
#include <QWheelEvent>
#include <QWidget>
#include <cmath>

#include "core/geometry/SectionSlab.h"
#include "ui/document/Presentation.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {

/// Where the ground is seen this edge on, the turn follows the mouse's way across.
constexpr double kLevel = 0.1;
constexpr double kRadiansPerPixel = 0.01;

/// The direction from the box's middle to what the cursor points at, in the level plane through it.
std::optional<double> headingAt(const ViewCamera& camera, const SectionBox& box, const QPointF& position) {
    const ViewRay ray = camera.ray({position.x(), position.y()});
    if (std::abs(ray.direction.z()) < kLevel) return std::nullopt;
    const double along = (box.centre.z() - ray.from.z()) / ray.direction.z();
    if (!camera.parallel && along <= 0) return std::nullopt;
    const Eigen::Vector3d arm = ray.from + along * ray.direction - box.centre;
    return std::atan2(arm.y(), arm.x());
}

}  // namespace

SectionTool::SectionTool(Presentation& presentation, QObject* parent)
    : QObject(parent), presentation_(presentation) {}

bool SectionTool::mousePress(SceneView& view, const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton || !presentation_.section()) return false;
    held_ = handleAt(*presentation_.section(), view.camera(), event.localPos());
    if (!held_) return false;
    begun_ = *presentation_.section();
    pressed_ = event.localPos();
    view.setHeldHandle(held_);
    return true;
}

void SectionTool::drag(const SceneView& view, const QPointF& position) {
    const QPointF moved = position - pressed_;
    if (held_->axis < 3) {
        const QPointF& metre = held_->pixelsPerM;
        const double square = QPointF::dotProduct(metre, metre);
        return presentation_.setSection(
            withFaceMoved(begun_, held_->axis, held_->side, QPointF::dotProduct(moved, metre) / square));
    }
    SectionBox turned = begun_;
    const auto from = headingAt(view.camera(), begun_, pressed_);
    const auto to = headingAt(view.camera(), begun_, position);
    turned.heading_rad += from && to ? *to - *from : kRadiansPerPixel * moved.x();
    turned.heading_rad = std::remainder(turned.heading_rad, 2 * std::acos(-1.0));
    presentation_.setSection(turned);
}

bool SectionTool::mouseMove(SceneView& view, const QMouseEvent& event) {
    if (!presentation_.section()) return false;
    if (held_) {
        drag(view, event.localPos());
        return true;
    }
    const bool over = event.buttons() == Qt::NoButton &&
                      handleAt(*presentation_.section(), view.camera(), event.localPos()).has_value();
    if (over != pointing_) {
        pointing_ = over;
        view.setHeldHandle(over ? handleAt(*presentation_.section(), view.camera(), event.localPos())
                                : std::nullopt);
    }
    return false;
}

bool SectionTool::mouseRelease(SceneView& view, const QMouseEvent& event) {
    if (!held_ || event.button() != Qt::LeftButton) return false;
    held_.reset();
    view.setHeldHandle(std::nullopt);
    return true;
}

bool SectionTool::wheel(SceneView&, const QWheelEvent& event) {
    if (!presentation_.section() || !(event.modifiers() & Qt::ControlModifier)) return false;
    if (event.angleDelta().y() != 0) step(event.angleDelta().y() > 0 ? 1 : -1);
    return true;
}

void SectionTool::step(int direction) {
    if (!presentation_.section()) return;
    const SectionBox& box = *presentation_.section();
    const int axis = thinAxis(box);
    presentation_.setSection(moved(box, axis, direction * 2 * box.halfSize[axis]));
}

}  // namespace vestige
