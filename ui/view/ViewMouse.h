#pragma once

#include <QtCore/qnamespace.h>
#include <QPoint>
#include <functional>
#include <optional>

#include "core/geometry/ViewCamera.h"

class QEvent;

namespace vestige {

/// Whose habits the mouse follows.
///   vestige:      left turns, right or middle (or left with Shift) moves
///   cloudCompare: left turns, right moves, middle zooms
///   slicer:       left turns, middle (or left with Shift) moves, right zooms; as F3D
/// In all of them the wheel zooms, and a middle click sets what the view turns about.
enum class NavigationPreset { vestige, cloudCompare, slicer };

/// Navigation by mouse. The view turns about the pivot that was set, else about the point under the cursor;
/// the wheel zooms to the cursor.
class ViewMouse {
  public:
    /// What the view gives: the world point under a position, if there is one.
    using PointUnder = std::function<std::optional<Eigen::Vector3d>(const QPoint&)>;

    explicit ViewMouse(PointUnder pointUnder) : pointUnder_(std::move(pointUnder)) {}

    void setPreset(NavigationPreset preset) { preset_ = preset; }
    void setPivot(const std::optional<Eigen::Vector3d>& pivot) { fixedPivot_ = pivot; }
    /// Called for a middle click, with its position.
    void onMiddleClick(std::function<void(const QPoint&)> react) { middleClicked_ = std::move(react); }

    /// The camera after the event; nothing when the event does not move it.
    std::optional<ViewCamera> handle(const QEvent& event, const ViewCamera& camera);

  private:
    enum class Drag { none, orbit, pan, zoom };

    Drag dragOf(Qt::MouseButton button, Qt::KeyboardModifiers modifiers) const;
    Eigen::Vector3d pointAt(const QPoint& position, const ViewCamera& camera) const;
    std::optional<ViewCamera> wheel(const QEvent& event, const ViewCamera& camera);
    std::optional<ViewCamera> dragged(const QPoint& position, const ViewCamera& camera);

    PointUnder pointUnder_;
    std::function<void(const QPoint&)> middleClicked_;
    NavigationPreset preset_ = NavigationPreset::vestige;
    std::optional<Eigen::Vector3d> fixedPivot_;
    Drag drag_ = Drag::none;
    QPoint pressed_;
    QPoint last_;
    bool moved_ = false;
    Eigen::Vector3d pivot_ = Eigen::Vector3d::Zero();
    std::optional<QPoint> wheelPlace_;
};

}  // namespace vestige
