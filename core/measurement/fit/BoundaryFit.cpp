#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/measurement/fit/EdgeFit.h"

namespace vestige {
namespace {

struct Spot {
    Eigen::Vector2d place;
    double energy;
};

/// What lies within the window from the line outwards, per metre of line and metre of width.
struct Column {
    double along = 0;
    double edge = 0;
    double variance = 0;
};

std::vector<Spot> spotsOn(const Neighbourhood& near, const PlaneFit& plane, const Eigen::Vector3d& origin) {
    const double reach = 2.5 * std::max(plane.rms, 0.3 * near.noise_m) + 1e-9;
    std::vector<Spot> spots;
    std::vector<double> energies;
    for (const FitPoint& each : near.points) {
        if (std::abs(plane.distance(each.position)) > reach) continue;
        const Eigen::Vector3d from = each.position - origin;
        spots.push_back({{plane.axes.col(0).dot(from), plane.axes.col(1).dot(from)}, each.energy});
        energies.push_back(each.energy);
    }
    if (spots.empty()) return spots;
    // Most of the plane's points were hit by the whole spot.
    const auto whole =
        energies.begin() + static_cast<std::ptrdiff_t>(0.6 * static_cast<double>(energies.size()));
    std::nth_element(energies.begin(), whole, energies.end());
    for (Spot& spot : spots) spot.energy = *whole > 0 ? std::min(1.0, spot.energy / *whole) : 1;
    return spots;
}

}  // namespace

std::optional<LineFit> boundaryOf(const Neighbourhood& near, const PlaneFit& plane, double clear) {
    const double slant = plane.normal.dot(near.view);
    Eigen::Vector3d origin = plane.project(Eigen::Vector3d::Zero());
    if (std::abs(slant) > 0.2) origin = plane.distance(Eigen::Vector3d::Zero()) / -slant * near.view;
    const std::vector<Spot> spots = spotsOn(near, plane, origin);
    if (spots.size() < 20) return std::nullopt;

    const double half = 0.5 * near.radius_m;    // of the strip along the edge
    const double depth = 0.45 * near.radius_m;  // how far inwards and outwards is looked
    struct Step {
        double contrast = 0;
        double angle = 0;
        double at = 0;
    } step;
    constexpr int kAngles = 72;
    constexpr int kPlaces = 13;
    for (int k = 0; k < kAngles; ++k) {
        const double angle = 2 * std::numbers::pi * k / kAngles;
        const Eigen::Vector2d out(std::cos(angle), std::sin(angle));
        const Eigen::Vector2d along(-out.y(), out.x());
        for (int place = 0; place < kPlaces; ++place) {
            const double at = 0.3 * near.radius_m * (2.0 * place / (kPlaces - 1) - 1);
            double inside = 0;
            double outside = 0;
            for (const Spot& spot : spots) {
                if (std::abs(along.dot(spot.place)) > half) continue;
                const double t = out.dot(spot.place) - at;
                if (t > -depth && t <= 0) inside += spot.energy;
                if (t > 0 && t < depth) outside += spot.energy;
            }
            const double contrast = (inside - 2 * outside) / (1 + std::abs(at) / near.radius_m);
            if (contrast > step.contrast) step = {contrast, angle, at};
        }
    }
    if (step.contrast < 10) return std::nullopt;

    double angle = step.angle;
    double at = step.at;
    double variance = 0;
    double slope2 = 0;
    std::size_t used = 0;
    double squares = 0;
    for (int round = 0; round < 4; ++round) {
        const Eigen::Vector2d out(std::cos(angle), std::sin(angle));
        const Eigen::Vector2d along(-out.y(), out.x());
        constexpr int kColumns = 6;
        std::vector<Column> columns;
        const double start = at - clear;
        const double from = at - clear - depth;
        used = 0;
        for (int k = 0; k < kColumns; ++k) {
            const double left = half * (2.0 * k / kColumns - 1);
            const double right = half * (2.0 * (k + 1) / kColumns - 1);
            double plateau = 0;
            double beyond = 0;
            double beyond2 = 0;
            for (const Spot& spot : spots) {
                const double s = along.dot(spot.place);
                const double t = out.dot(spot.place);
                if (s < left || s >= right) continue;
                if (t >= from && t < start) plateau += spot.energy;
                if (t < start || t > at + 1.5 * clear) continue;
                beyond += spot.energy;
                beyond2 += spot.energy * spot.energy;
                ++used;
            }
            if (plateau < 6) continue;
            const double density = plateau / depth;
            const double width = beyond / density;
            columns.push_back({0.5 * (left + right), start + width,
                               (beyond2 + 1) / (density * density) + width * width / plateau});
        }
        if (columns.size() < 3) return std::nullopt;
        Eigen::Vector2d line(at, 0);
        Eigen::Matrix2d normal;
        for (int pass = 0; pass < 8; ++pass) {
            normal.setZero();
            Eigen::Vector2d right = Eigen::Vector2d::Zero();
            squares = 0;
            for (const Column& column : columns) {
                const double residual = column.edge - line[0] - line[1] * column.along;
                const double weight =
                    (pass == 0 ? 1 : tukeyWeight(residual, std::sqrt(column.variance) + 0.1 * clear)) /
                    column.variance;
                const Eigen::Vector2d row(1, column.along);
                normal += weight * row * row.transpose();
                right += weight * column.edge * row;
                squares += residual * residual / static_cast<double>(columns.size());
            }
            if (!(normal.determinant() > 0)) return std::nullopt;
            line = normal.inverse() * right;
        }
        variance = normal.inverse()(0, 0);
        slope2 = normal.inverse()(1, 1);
        if (std::abs(line[1]) > 1 || std::abs(line[0]) > near.radius_m) return std::nullopt;
        angle -= std::atan(line[1]);
        at = line[0] * std::cos(std::atan(line[1]));
    }
    LineFit line;
    const Eigen::Vector3d out = std::cos(angle) * plane.axes.col(0) + std::sin(angle) * plane.axes.col(1);
    line.direction = plane.normal.cross(out).normalized();
    line.point = nearestToView(origin + at * out, line.direction, near.view);
    const double alongVariance = near.spacing_m * near.spacing_m / 12;
    line.covariance = variance * out * out.transpose() +
                      plane.varianceAt(line.point) * plane.normal * plane.normal.transpose() +
                      alongVariance * line.direction * line.direction.transpose();
    line.slope = std::sqrt(slope2);
    line.rms = std::sqrt(squares);
    line.inliers = used;
    return line;
}

}  // namespace vestige
