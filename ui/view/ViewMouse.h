#pragma once

#include <QPoint>
#include <functional>
#include <optional>

#include "core/geometry/ViewCamera.h"

class QEvent;

namespace vestige {

/// Navigation by mouse: the left button orbits round the point under the cursor, the right or middle button
/// (or left with Shift) pans, the wheel zooms to the cursor.
class ViewMouse {
  public:
    /// What the view gives: the world point under a position, if there is one.
    using PointUnder = std::function<std::optional<Eigen::Vector3d>(const QPoint&)>;

    explicit ViewMouse(PointUnder pointUnder) : pointUnder_(std::move(pointUnder)) {}

    /// The camera after the event; nothing when the event does not move it.
    std::optional<ViewCamera> handle(const QEvent& event, const ViewCamera& camera);

  private:
    enum class Drag { none, orbit, pan };

    Eigen::Vector3d pivotAt(const QPoint& position, const ViewCamera& camera) const;
    std::optional<ViewCamera> wheel(const QEvent& event, const ViewCamera& camera);

    PointUnder pointUnder_;
    Drag drag_ = Drag::none;
    QPoint last_;
    Eigen::Vector3d pivot_ = Eigen::Vector3d::Zero();
    std::optional<QPoint> wheelPlace_;
};

}  // namespace vestige
