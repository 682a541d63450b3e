#pragma once

#include <QPointF>
#include <QRectF>
#include <optional>
#include <vector>

#include "core/geometry/SectionBox.h"
#include "core/geometry/ViewCamera.h"

class QPainter;

namespace vestige {

struct ViewTheme;

/// What the mouse can take hold of on a section box: a face, to be moved along its axis, or the turn of the
/// whole box about its upright axis.
struct SectionHandle {
    int axis = 0;        ///< 0 to 2: a face of that axis; 3: the turn
    int side = 1;        ///< 1 or -1
    QPointF place;       ///< pixels
    QPointF pixelsPerM;  ///< of a face: how far the handle goes in the picture for a metre
    bool same(const SectionHandle& other) const { return axis == other.axis && side == other.side; }
};

/// Those that can be dragged from here: faces that are seen from aside.
std::vector<SectionHandle> sectionHandles(const SectionBox& box, const ViewCamera& camera);

/// The handle within reach of a position.
std::optional<SectionHandle> handleAt(const SectionBox& box, const ViewCamera& camera,
                                      const QPointF& position);

/// The box's edges and handles, the held one emphasised.
void paintSection(QPainter& painter, const ViewTheme& theme, const QRectF& picture, const ViewCamera& camera,
                  const SectionBox& box, const std::optional<SectionHandle>& held);

}  // namespace vestige
