#include "core/measurement/fit/FittedLength.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace vestige {
namespace {

constexpr double kParallel = 0.966;  // cosine of 15 degrees
constexpr double kInPlane = 0.5;
/// Nobody looks at a cloud with 30 mm of noise from nearer.
constexpr double kNearestEye_m = 2;

bool isCircle(const FittedEnd& end) {
    return end.feature.mode == SnapMode::circle && end.feature.radius > 0;
}

bool areOneCircle(const FittedEnd& a, const FittedEnd& b) {
    const double radius = std::max(a.feature.radius, b.feature.radius);
    return isCircle(a) && isCircle(b) && (a.feature.position - b.feature.position).norm() < 0.2 * radius &&
           std::abs(a.feature.axis.dot(b.feature.axis)) > 0.94;
}

FittedLength diameter(const FittedEnd& a, const FittedEnd& b) {
    FittedLength result;
    result.length_m = a.feature.radius + b.feature.radius;
    const double u = 0.5 * (a.feature.radiusUncertainty + b.feature.radiusUncertainty);
    result.variance_m2 = 4 * u * u;
    const Eigen::Vector3d middle = 0.5 * (a.feature.position + b.feature.position);
    Eigen::Vector3d along = b.pick - a.pick;
    along -= a.feature.axis.dot(along) * a.feature.axis;
    along = 0.5 * result.length_m * along.normalized();
    result.a = middle - along;
    result.b = middle + along;
    return result;
}

/// Where an end stands on the way to the other, and its covariance.
struct Place {
    Eigen::Vector3d position;
    Eigen::Matrix3d covariance;
};

Place placeOf(const FittedEnd& end, const Eigen::Vector3d& towards) {
    Place place{end.feature.position, end.feature.covariance};
    if (!isCircle(end)) return place;
    const Eigen::Vector3d& axis = end.feature.axis;
    Eigen::Vector3d out = end.pick - end.feature.position;
    out -= axis.dot(out) * axis;
    if (out.norm() < 0.5 * end.feature.radius) return place;
    Eigen::Vector3d along = towards - end.feature.position;
    along -= axis.dot(along) * axis;
    if (along.norm() < 1e-9) return place;
    along.normalize();
    if (along.dot(out) < 0) along = -along;
    place.position += end.feature.radius * along;
    place.covariance +=
        end.feature.radiusUncertainty * end.feature.radiusUncertainty * along * along.transpose();
    return place;
}

}  // namespace

FittedLength fittedLength(const FittedEnd& a, const FittedEnd& b) {
    if (areOneCircle(a, b)) return diameter(a, b);
    const Place from = placeOf(a, b.feature.position);
    const Place to = placeOf(b, a.feature.position);
    FittedLength result;
    result.a = from.position;
    result.b = to.position;
    Eigen::Vector3d way = to.position - from.position;
    const SnapMode mode = a.feature.mode;
    const bool alike = mode == b.feature.mode;
    double cosine = a.feature.axis.dot(b.feature.axis);
    double slope = 0;
    if (alike && mode == SnapMode::edge && std::abs(cosine) > kParallel) {
        const Eigen::Vector3d axis =
            (a.feature.axis + std::copysign(1.0, cosine) * b.feature.axis).normalized();
        const Eigen::Vector3d across = way - axis.dot(way) * axis;
        // Edges that share a line have no distance across; then the ends were meant as they are.
        if (across.norm() > 0.5 * way.norm()) {
            const double turn = 0.5 * std::hypot(a.feature.axisUncertainty, b.feature.axisUncertainty);
            slope = turn * axis.dot(way);
            way = across;
            result.b = result.a + way;
        }
    }
    if (alike && mode == SnapMode::plane && std::abs(cosine) > kParallel) {
        const Eigen::Vector3d normal =
            (a.feature.axis + std::copysign(1.0, cosine) * b.feature.axis).normalized();
        const double height = normal.dot(way);
        const double aside = std::sqrt(std::max(0.0, way.squaredNorm() - height * height));
        const double turn = 0.5 * std::hypot(a.feature.axisUncertainty, b.feature.axisUncertainty);
        // Two places on one plane are as far apart as they are; it is planes opposite each other that are
        // meant. Places aside from each other make the straight way too long by aside^2 / 2L; a normal that
        // is off by `turn` makes the height wrong by aside times that.
        const bool through = std::abs(height) > 0.7 * way.norm();
        if (through && turn * aside < 0.5 * aside * aside / std::abs(height)) {
            slope = turn * aside;
            way = height * normal;
            result.b = result.a + way;
        }
    }
    result.length_m = way.norm();
    const Eigen::Vector3d along =
        result.length_m > 0 ? way / result.length_m : Eigen::Vector3d::UnitX().eval();
    // Ends pointed at on planes that the length lies in: the same, from an eye whose distance is not known.
    const double tilt = std::max(std::abs(a.feature.axis.dot(along)), std::abs(b.feature.axis.dot(along)));
    if (alike && mode == SnapMode::plane && tilt < kInPlane)
        slope = std::max(a.feature.rms, b.feature.rms) * result.length_m / kNearestEye_m;
    // What was pointed at may lie before or behind what is seen there, at both ends alike; lines of sight
    // that part make that a part of the length.
    if (alike && mode == SnapMode::surface) {
        const double depth = std::max(a.feature.rms, b.feature.rms);
        slope = depth * along.dot(a.feature.axis - b.feature.axis);
    }
    result.variance_m2 = along.dot((from.covariance + to.covariance) * along) + slope * slope;
    return result;
}

}  // namespace vestige
