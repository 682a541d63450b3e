#include "ui/view/PlanGrid.h"

#include <Eigen/Geometry>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "core/base/Numbers.h"
#include "ui/view/ViewTheme.h"

namespace vestige {
namespace {

constexpr double kLeastSpacing_px = 64;
constexpr int kLineAlpha = 70;

struct Directions {
    Eigen::Vector3d right;
    Eigen::Vector3d up;
};

Directions directions(const ViewCamera& camera) {
    const Eigen::Vector3d forward = camera.direction();
    const Eigen::Vector3d right = forward.cross(camera.viewUp).normalized();
    return {right, right.cross(forward)};
}

bool alongAxis(const Eigen::Vector3d& direction) {
    return direction.cwiseAbs().maxCoeff() > 1 - 1e-9;
}

int axisAlong(const Eigen::Vector3d& direction) {
    int axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    return axis;
}

/// Letters with a casing, so that they are read over points of any colour.
void paintCoordinate(QPainter& painter, const ViewTheme& theme, const QPointF& baseline,
                     const QString& text) {
    QPainterPath letters;
    letters.addText(baseline, painter.font(), text);
    painter.strokePath(letters, QPen(theme.casing, 3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(letters, theme.text);
}

}  // namespace

double gridSpacing_m(const ViewCamera& camera) {
    const double depth = (camera.focalPoint - camera.position).norm();
    const double least = kLeastSpacing_px * camera.metresPerPixel(depth);
    if (!(least > 0) || !std::isfinite(least)) return 1;
    const double power = std::pow(10, std::floor(std::log10(least)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (digit * power >= least * (1 - 1e-9)) return digit * power;
    return 10 * power;
}

bool showsPlan(const ViewCamera& camera) {
    const Directions view = directions(camera);
    return camera.parallel && alongAxis(view.right) && alongAxis(view.up);
}

std::vector<QRectF> paintPlanGrid(QPainter& painter, const ViewTheme& theme, const QRectF& picture,
                                  const ViewCamera& camera, const std::vector<QRectF>& taken) {
    const Directions view = directions(camera);
    const double spacing = gridSpacing_m(camera);
    const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(spacing) - 1e-9)));
    QColor color = theme.quietText;
    color.setAlpha(kLineAlpha);
    painter.setFont(theme.font(10));
    std::vector<QRectF> places;
    const double metres = camera.metresPerPixel(1);
    const auto lines = [&](const Eigen::Vector3d& along, double pixels, const auto& paint) {
        const int axis = axisAlong(along);
        const double sign = along[axis] > 0 ? 1 : -1;
        const double centre = camera.position[axis];
        const double reach = 0.5 * pixels * metres;
        for (double k = std::ceil((centre - reach) / spacing); k * spacing <= centre + reach; ++k) {
            const double offset_px = sign * (k * spacing - centre) / metres;
            paint(offset_px, QString::fromStdString(fixedText(k * spacing == 0 ? 0 : k * spacing, decimals)));
        }
    };
    const auto label = [&](const QRectF& place, const QString& text) {
        const QRectF around = place.adjusted(-4, -2, 4, 2);
        if (!picture.contains(around)) return;
        for (const auto* others : {&taken, static_cast<const std::vector<QRectF>*>(&places)})
            if (std::any_of(others->begin(), others->end(),
                            [&](const QRectF& other) { return other.intersects(around); }))
                return;
        paintCoordinate(painter, theme, {place.left(), place.bottom() - 3}, text);
        places.push_back(place);
    };
    lines(view.right, picture.width(), [&](double offset, const QString& text) {
        const double x = picture.center().x() + offset;
        painter.setPen(QPen(color, 1));
        painter.drawLine(QPointF(x, picture.top()), QPointF(x, picture.bottom()));
        const double width = painter.fontMetrics().horizontalAdvance(text);
        label({x + 4, picture.bottom() - 17, width, 13}, text);
    });
    lines(view.up, picture.height(), [&](double offset, const QString& text) {
        const double y = picture.center().y() - offset;
        painter.setPen(QPen(color, 1));
        painter.drawLine(QPointF(picture.left(), y), QPointF(picture.right(), y));
        const double width = painter.fontMetrics().horizontalAdvance(text);
        label({picture.right() - width - 6, y - 15, width, 13}, text);
    });
    return places;
}

}  // namespace vestige
