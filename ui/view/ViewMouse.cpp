#include "ui/view/ViewMouse.h"

#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "ui/view/Navigation.h"

namespace vestige {
namespace {

double depthOf(const Eigen::Vector3d& world, const ViewCamera& camera) {
    return (world - camera.position).dot(camera.direction());
}

}  // namespace

Eigen::Vector3d ViewMouse::pivotAt(const QPoint& position, const ViewCamera& camera) const {
    if (const auto under = pointUnder_(position)) return *under;
    const ViewRay ray = camera.ray({position.x() + 0.5, position.y() + 0.5});
    const double depth = depthOf(camera.focalPoint, camera);
    return ray.from + ray.direction * (depth / ray.direction.dot(camera.direction()));
}

std::optional<ViewCamera> ViewMouse::wheel(const QEvent& event, const ViewCamera& camera) {
    const auto& wheel = static_cast<const QWheelEvent&>(event);
    const QPoint position = wheel.position().toPoint();
    if (wheel.angleDelta().y() == 0) return std::nullopt;
    // Turning the wheel without moving the mouse keeps its aim, although the point drawn there may change.
    if (wheelPlace_ != position) {
        pivot_ = pivotAt(position, camera);
        wheelPlace_ = position;
    }
    return zoomed(camera, pivot_, std::pow(0.85, wheel.angleDelta().y() / 120.0));
}

std::optional<ViewCamera> ViewMouse::handle(const QEvent& event, const ViewCamera& camera) {
    if (event.type() == QEvent::Wheel) return wheel(event, camera);
    const auto& mouse = static_cast<const QMouseEvent&>(event);
    if (event.type() == QEvent::MouseButtonPress) {
        const bool pan = mouse.button() == Qt::RightButton || mouse.button() == Qt::MiddleButton ||
                         (mouse.modifiers() & Qt::ShiftModifier);
        drag_ = pan ? Drag::pan : Drag::orbit;
        last_ = mouse.pos();
        pivot_ = pivotAt(mouse.pos(), camera);
        wheelPlace_.reset();
        return std::nullopt;
    }
    if (event.type() == QEvent::MouseButtonRelease) {
        drag_ = Drag::none;
        return std::nullopt;
    }
    if (event.type() != QEvent::MouseMove) return std::nullopt;
    if (mouse.buttons() == Qt::NoButton) drag_ = Drag::none;
    if (mouse.pos() != wheelPlace_) wheelPlace_.reset();
    if (drag_ == Drag::none || mouse.pos() == last_) return std::nullopt;
    const Eigen::Vector2d moved(mouse.x() - last_.x(), mouse.y() - last_.y());
    last_ = mouse.pos();
    if (drag_ == Drag::pan) return panned(camera, depthOf(pivot_, camera), moved);
    return focusedAt(orbited(camera, pivot_, moved), depthOf(pivot_, orbited(camera, pivot_, moved)));
}

}  // namespace vestige
