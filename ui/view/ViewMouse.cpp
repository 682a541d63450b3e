#include "ui/view/ViewMouse.h"

#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "ui/view/Navigation.h"

namespace vestige {
namespace {

constexpr double kZoomPerPixel = 0.008;
constexpr int kClick_px = 4;

double depthOf(const Eigen::Vector3d& world, const ViewCamera& camera) {
    return (world - camera.position).dot(camera.direction());
}

}  // namespace

ViewMouse::Drag ViewMouse::dragOf(Qt::MouseButton button, Qt::KeyboardModifiers modifiers) const {
    const bool shifted = modifiers & Qt::ShiftModifier;
    switch (preset_) {
        case NavigationPreset::cloudCompare:
            return button == Qt::RightButton || shifted ? Drag::pan
                   : button == Qt::MiddleButton         ? Drag::zoom
                                                        : Drag::orbit;
        case NavigationPreset::slicer:
            return button == Qt::MiddleButton || shifted ? Drag::pan
                   : button == Qt::RightButton           ? Drag::zoom
                                                         : Drag::orbit;
        case NavigationPreset::vestige:
            break;
    }
    return button == Qt::RightButton || button == Qt::MiddleButton || shifted ? Drag::pan : Drag::orbit;
}

Eigen::Vector3d ViewMouse::pointAt(const QPoint& position, const ViewCamera& camera) const {
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
        pivot_ = pointAt(position, camera);
        wheelPlace_ = position;
    }
    return zoomed(camera, pivot_, std::pow(0.85, wheel.angleDelta().y() / 120.0));
}

std::optional<ViewCamera> ViewMouse::dragged(const QPoint& position, const ViewCamera& camera) {
    const Eigen::Vector2d moved(position.x() - last_.x(), position.y() - last_.y());
    last_ = position;
    if (drag_ == Drag::pan) return panned(camera, depthOf(pivot_, camera), moved);
    if (drag_ == Drag::zoom) return zoomed(camera, pivot_, std::exp(kZoomPerPixel * moved.y()));
    const ViewCamera turned = orbited(camera, pivot_, moved);
    return focusedAt(turned, depthOf(pivot_, turned));
}

std::optional<ViewCamera> ViewMouse::handle(const QEvent& event, const ViewCamera& camera) {
    if (event.type() == QEvent::Wheel) return wheel(event, camera);
    const auto& mouse = static_cast<const QMouseEvent&>(event);
    if (event.type() == QEvent::MouseButtonPress) {
        drag_ = dragOf(mouse.button(), mouse.modifiers());
        pressed_ = last_ = mouse.pos();
        moved_ = false;
        pivot_ = drag_ == Drag::orbit && fixedPivot_ ? *fixedPivot_ : pointAt(mouse.pos(), camera);
        wheelPlace_.reset();
        return std::nullopt;
    }
    if (event.type() == QEvent::MouseButtonRelease) {
        const bool click = drag_ != Drag::none && !moved_;
        drag_ = Drag::none;
        if (click && mouse.button() == Qt::MiddleButton && middleClicked_) middleClicked_(mouse.pos());
        return std::nullopt;
    }
    if (event.type() != QEvent::MouseMove) return std::nullopt;
    if (mouse.buttons() == Qt::NoButton) drag_ = Drag::none;
    if (mouse.pos() != wheelPlace_) wheelPlace_.reset();
    moved_ = moved_ || (mouse.pos() - pressed_).manhattanLength() >= kClick_px;
    if (drag_ == Drag::none || mouse.pos() == last_) return std::nullopt;
    return dragged(mouse.pos(), camera);
}

}  // namespace vestige
