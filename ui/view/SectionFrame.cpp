#include "ui/view/SectionFrame.h"

#include <QLineF>
#include <QPainter>
#include <cmath>

#include "core/geometry/SectionSlab.h"
#include "ui/view/SeenLine.h"
#include "ui/view/ViewTheme.h"

namespace vestige {
namespace {

constexpr double kReach_px = 11;
constexpr double kRadius_px = 6;
/// Of the size that a metre has across the view: less is too steep to be dragged.
constexpr double kLeastAside = 0.15;

Eigen::Vector3d corner(const SectionBox& box, int number) {
    Eigen::Vector3d place = box.centre;
    for (int axis = 0; axis < 3; ++axis)
        place += ((number >> axis) & 1 ? 1 : -1) * box.halfSize[axis] * axisOf(box, axis);
    return place;
}

QPointF pixelOf(const PixelPoint& seen) {
    return {seen.pixel.x(), seen.pixel.y()};
}

}  // namespace

std::vector<SectionHandle> sectionHandles(const SectionBox& box, const ViewCamera& camera) {
    std::vector<SectionHandle> handles;
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {1, -1}) {
            const Eigen::Vector3d outward = side * axisOf(box, axis);
            const Eigen::Vector3d face = box.centre + box.halfSize[axis] * outward;
            const auto seen = camera.project(face);
            if (!seen) continue;
            const double step_m = 10 * camera.metresPerPixel(seen->depth_m);
            const auto beside = camera.project(face + step_m * outward);
            if (!(step_m > 0) || !beside) continue;
            const QPointF aside = pixelOf(*beside) - pixelOf(*seen);
            if (std::hypot(aside.x(), aside.y()) < 10 * kLeastAside) continue;
            handles.push_back({axis, side, pixelOf(*seen), aside / step_m});
        }
    const Eigen::Vector3d edge =
        box.centre + box.halfSize.x() * axisOf(box, 0) + box.halfSize.y() * axisOf(box, 1);
    if (const auto seen = camera.project(edge)) handles.push_back({3, 1, pixelOf(*seen), {}});
    return handles;
}

std::optional<SectionHandle> handleAt(const SectionBox& box, const ViewCamera& camera,
                                      const QPointF& position) {
    std::optional<SectionHandle> nearest;
    double least = kReach_px;
    for (const SectionHandle& handle : sectionHandles(box, camera)) {
        const double apart = QLineF(handle.place, position).length();
        if (apart <= least) nearest = handle;
        least = std::min(least, apart);
    }
    return nearest;
}

void paintSection(QPainter& painter, const ViewTheme& theme, const QRectF& picture, const ViewCamera& camera,
                  const SectionBox& box, const std::optional<SectionHandle>& held) {
    for (const auto& [color, width] : {std::pair(theme.casing, 3.2), std::pair(theme.highlight, 1.3)}) {
        painter.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap));
        for (int from = 0; from < 8; ++from)
            for (int axis = 0; axis < 3; ++axis) {
                const int to = from | 1 << axis;
                if (to == from) continue;
                const auto line = seenLine(camera, corner(box, from), corner(box, to));
                if (!line) continue;
                if (const auto part = cropped(*line, picture)) painter.drawLine(part->a, part->b);
            }
    }
    for (const SectionHandle& handle : sectionHandles(box, camera)) {
        const bool isHeld = held && held->same(handle);
        const double radius = isHeld ? kRadius_px + 2 : kRadius_px;
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme.casing);
        painter.drawEllipse(handle.place, radius + 2, radius + 2);
        painter.setPen(QPen(theme.line, 1.5));
        if (handle.axis == 3) {
            // A ring: it turns.
            painter.setBrush(Qt::NoBrush);
            painter.setPen(QPen(theme.highlight, isHeld ? 4 : 3));
            painter.drawEllipse(handle.place, radius - 1, radius - 1);
        } else {
            painter.setBrush(theme.highlight);
            painter.drawEllipse(handle.place, radius, radius);
        }
    }
    painter.setBrush(Qt::NoBrush);
}

}  // namespace vestige
