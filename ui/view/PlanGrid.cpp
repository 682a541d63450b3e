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

namespace {

/// Calls `paint(offset from the picture's middle in pixels, coordinate)` for the lines across a direction.
template <class Paint>
void eachLine(const ViewCamera& camera, const Eigen::Vector3d& along, double pixels, const Paint& paint) {
    const double spacing = gridSpacing_m(camera);
    const double metres = camera.metresPerPixel(1);
    const int axis = axisAlong(along);
    const double sign = along[axis] > 0 ? 1 : -1;
    const double centre = camera.position[axis];
    const double reach = 0.5 * pixels * metres;
    for (double k = std::ceil((centre - reach) / spacing); k * spacing <= centre + reach; ++k)
        paint(sign * (k * spacing - centre) / metres, k == 0 ? 0.0 : k * spacing);
}

}  // namespace

void paintPlanGrid(QPainter& painter, const ViewTheme& theme, const QRectF& picture,
                   const ViewCamera& camera) {
    const Directions view = directions(camera);
    QColor color = theme.quietText;
    color.setAlpha(kLineAlpha);
    painter.setPen(QPen(color, 1));
    eachLine(camera, view.right, picture.width(), [&](double offset, double) {
        const double x = picture.center().x() + offset;
        painter.drawLine(QPointF(x, picture.top()), QPointF(x, picture.bottom()));
    });
    eachLine(camera, view.up, picture.height(), [&](double offset, double) {
        const double y = picture.center().y() - offset;
        painter.drawLine(QPointF(picture.left(), y), QPointF(picture.right(), y));
    });
}

std::vector<QRectF> paintPlanCoordinates(QPainter& painter, const ViewTheme& theme, const QRectF& picture,
                                         const ViewCamera& camera, const std::vector<QRectF>& taken) {
    const Directions view = directions(camera);
    const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(gridSpacing_m(camera)) - 1e-9)));
    painter.setFont(theme.font(10));
    std::vector<QRectF> places;
    const auto isFree = [&](const QRectF& around) {
        const auto meets = [&](const QRectF& other) { return other.intersects(around); };
        return picture.contains(around) && std::none_of(taken.begin(), taken.end(), meets) &&
               std::none_of(places.begin(), places.end(), meets);
    };
    const auto label = [&](const QPointF& corner, double value) {
        const QString text = QString::fromStdString(fixedText(value, decimals));
        const QRectF place(corner, QSizeF(painter.fontMetrics().horizontalAdvance(text), 13));
        if (!isFree(place.adjusted(-4, -2, 4, 2))) return;
        paintCoordinate(painter, theme, {place.left(), place.bottom() - 3}, text);
        places.push_back(place);
    };
    eachLine(camera, view.right, picture.width(), [&](double offset, double value) {
        label({picture.center().x() + offset + 4, picture.bottom() - 17}, value);
    });
    eachLine(camera, view.up, picture.height(), [&](double offset, double value) {
        const QString text = QString::fromStdString(fixedText(value, decimals));
        const double width = painter.fontMetrics().horizontalAdvance(text);
        label({picture.right() - width - 6, picture.center().y() - offset - 15}, value);
    });
    return places;
}

}  // namespace vestige
