#include "ui/view/SeenLine.h"

#include <algorithm>

namespace vestige {

std::optional<SeenLine> seenLine(const ViewCamera& camera, Eigen::Vector3d a, Eigen::Vector3d b) {
    SeenLine segment;
    if (!camera.parallel) {
        const double closest = 1e-3;
        const double depthA = (a - camera.position).dot(camera.direction());
        const double depthB = (b - camera.position).dot(camera.direction());
        if (depthA < closest && depthB < closest) return std::nullopt;
        segment.aShown = depthA >= closest;
        segment.bShown = depthB >= closest;
        if (!segment.aShown) a += (b - a) * (closest - depthA) / (depthB - depthA);
        if (!segment.bShown) b += (a - b) * (closest - depthB) / (depthA - depthB);
    }
    const auto atA = camera.project(a);
    const auto atB = camera.project(b);
    if (!atA || !atB) return std::nullopt;
    segment.a = {atA->pixel.x(), atA->pixel.y()};
    segment.b = {atB->pixel.x(), atB->pixel.y()};
    return segment;
}

std::optional<SeenLine> cropped(const SeenLine& whole, const QRectF& box) {
    double from = 0;
    double to = 1;
    const QPointF step = whole.b - whole.a;
    const auto cut = [&](double along, double room) {
        if (along == 0) return room >= 0;
        if (along < 0)
            from = std::max(from, room / along);
        else
            to = std::min(to, room / along);
        return from <= to;
    };
    if (!cut(-step.x(), whole.a.x() - box.left()) || !cut(step.x(), box.right() - whole.a.x()) ||
        !cut(-step.y(), whole.a.y() - box.top()) || !cut(step.y(), box.bottom() - whole.a.y()))
        return std::nullopt;
    return SeenLine{whole.a + from * step, whole.a + to * step, whole.aShown && from == 0,
                    whole.bShown && to == 1};
}

}  // namespace vestige
