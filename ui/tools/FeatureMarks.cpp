#include "ui/tools/FeatureMarks.h"

#include <Eigen/Geometry>
#include <QPainter>
#include <QPolygonF>
#include <cmath>

#include "ui/view/ViewTheme.h"

namespace vestige {
namespace {

constexpr double kPatch_px = 34;
constexpr double kLine_px = 70;
constexpr int kChords = 72;
constexpr double kPi = 3.14159265358979323846;

/// Two unit directions across `axis`.
std::pair<Eigen::Vector3d, Eigen::Vector3d> across(const Eigen::Vector3d& axis) {
    const Eigen::Vector3d u = axis.unitOrthogonal();
    return {u, axis.cross(u)};
}

/// The part before the viewer.
QPolygonF projected(const ViewCamera& camera, const std::vector<Eigen::Vector3d>& points) {
    QPolygonF line;
    for (const Eigen::Vector3d& point : points)
        if (const auto seen = camera.project(point)) line << QPointF(seen->pixel.x(), seen->pixel.y());
    return line;
}

class FeaturePainter {
  public:
    FeaturePainter(QPainter& painter, const ViewTheme& theme, const ViewCamera& camera,
                   const FittedFeature& feature, const QPointF& at, double depth_m)
        : painter_(painter), theme_(theme), camera_(camera), feature_(feature), at_(at) {
        pixel_m_ = camera.metresPerPixel(depth_m);
    }

    void paint() {
        switch (feature_.mode) {
            case SnapMode::point:
                return;
            case SnapMode::plane:
                return patch();
            case SnapMode::edge:
                return line();
            case SnapMode::corner:
                return sign({at_ + QPointF(0, -10), at_ + QPointF(10, 0), at_ + QPointF(0, 10),
                             at_ + QPointF(-10, 0)});
            case SnapMode::highest:
                return sign({at_, at_ + QPointF(9, 14), at_ + QPointF(-9, 14)});
            case SnapMode::lowest:
                return sign({at_, at_ + QPointF(9, -14), at_ + QPointF(-9, -14)});
            case SnapMode::circle:
                return circle();
            case SnapMode::centroid:
            case SnapMode::surface:
                return cross(9);
        }
    }

  private:
    bool hasAxis() const { return feature_.axis.norm() > 0.5; }

    void stroke(const QVector<QPointF>& shape, bool closed) {
        for (const auto& [color, width] : {std::pair(theme_.casing, 4.0), std::pair(theme_.highlight, 1.8)}) {
            painter_.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
            if (closed)
                painter_.drawPolygon(QPolygonF(shape));
            else
                painter_.drawPolyline(QPolygonF(shape));
        }
    }

    void sign(const QVector<QPointF>& shape) { stroke(shape, true); }

    void cross(double reach) {
        stroke({at_ - QPointF(reach, 0), at_ + QPointF(reach, 0)}, false);
        stroke({at_ - QPointF(0, reach), at_ + QPointF(0, reach)}, false);
    }

    void patch() {
        if (!hasAxis()) return;
        const auto [u, v] = across(feature_.axis);
        const double half = kPatch_px * pixel_m_;
        const Eigen::Vector3d& p = feature_.position;
        QColor fill = theme_.highlight;
        fill.setAlpha(56);
        painter_.setBrush(fill);
        stroke(projected(camera_,
                         {p + half * (u + v), p + half * (u - v), p - half * (u + v), p - half * (u - v)}),
               true);
        painter_.setBrush(Qt::NoBrush);
        const Eigen::Vector3d up =
            feature_.axis.dot(camera_.direction()) > 0 ? Eigen::Vector3d(-feature_.axis) : feature_.axis;
        stroke(projected(camera_, {p, p + 0.8 * half * up}), false);
    }

    void line() {
        if (!hasAxis()) return cross(7);
        const Eigen::Vector3d reach = kLine_px * pixel_m_ * feature_.axis;
        stroke(projected(camera_, {feature_.position - reach, feature_.position, feature_.position + reach}),
               false);
    }

    void circle() {
        if (hasAxis() && feature_.radius > 0) {
            const auto [u, v] = across(feature_.axis);
            std::vector<Eigen::Vector3d> rim;
            for (int i = 0; i < kChords; ++i) {
                const double angle = 2 * kPi * i / kChords;
                rim.push_back(feature_.position +
                              feature_.radius * (std::cos(angle) * u + std::sin(angle) * v));
            }
            stroke(projected(camera_, rim), true);
        }
        cross(6);
    }

    QPainter& painter_;
    const ViewTheme& theme_;
    const ViewCamera& camera_;
    const FittedFeature& feature_;
    QPointF at_;
    double pixel_m_ = 0;
};

}  // namespace

void paintFeature(QPainter& painter, const ViewTheme& theme, const ViewCamera& camera,
                  const ProbedPick& pick) {
    if (!pick.feature) return;
    const auto seen = camera.project(pick.feature->position);
    if (!seen) return;
    const QPointF at(seen->pixel.x(), seen->pixel.y());
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    if (const auto from = camera.project(pick.measured)) {
        painter.setPen(QPen(theme.casing, 4));
        painter.drawLine(QPointF(from->pixel.x(), from->pixel.y()), at);
        painter.setPen(QPen(theme.highlight, 1.8, Qt::DashLine));
        painter.drawLine(QPointF(from->pixel.x(), from->pixel.y()), at);
    }
    FeaturePainter(painter, theme, camera, *pick.feature, at, seen->depth_m).paint();
    // The place itself, whatever shape stands round it.
    painter.setPen(QPen(theme.casing, 1.5));
    painter.setBrush(theme.line);
    painter.drawEllipse(at, 3.2, 3.2);
    painter.restore();
}

}  // namespace vestige
