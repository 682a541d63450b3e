#include "core/measurement/fit/EdgeFit.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/measurement/fit/SilhouetteFit.h"

namespace vestige {
namespace {

/// Points of the plane on that side of the line that are at least `clear` away from it.
std::vector<FitPoint> sideOf(const Neighbourhood& near, const PlaneFit& plane, const Eigen::Vector3d& point,
                             const Eigen::Vector3d& outwards, double clear, double noise) {
    std::vector<FitPoint> side;
    for (const FitPoint& each : near.points) {
        if (std::abs(plane.distance(each.position)) > 2.8 * noise) continue;
        if (outwards.dot(each.position - point) < -clear) side.push_back(each);
    }
    return side;
}

/// The direction in the plane, across the line, that points away from most of the plane's points.
Eigen::Vector3d outwardsOf(const Neighbourhood& near, const PlaneFit& plane, const Eigen::Vector3d& point,
                           const Eigen::Vector3d& direction, double clear, double noise) {
    const Eigen::Vector3d across = plane.normal.cross(direction).normalized();
    double balance = 0;
    for (const FitPoint& each : near.points) {
        const double distance = across.dot(each.position - point);
        if (std::abs(distance) < clear) continue;
        const double weight = tukeyWeight(plane.distance(each.position), noise);
        balance += distance > 0 ? weight : -weight;
    }
    return balance > 0 ? Eigen::Vector3d(-across) : across;
}

}  // namespace

Eigen::Vector3d nearestToView(const Eigen::Vector3d& point, const Eigen::Vector3d& direction,
                              const Eigen::Vector3d& view) {
    const Eigen::Vector3d foot = point - direction.dot(point) * direction;
    const double cosine = direction.dot(view);
    const double sine2 = 1 - cosine * cosine;
    // Seen along itself, a line has no such place; the one nearest to the seed stands for it.
    if (sine2 < 0.03) return foot;
    return foot - cosine * view.dot(foot) / sine2 * direction;
}

std::optional<LineFit> creaseOf(const Neighbourhood& near, const PlaneFit& first, const PlaneFit& second,
                                double clear_m) {
    constexpr double kLeastSine = 0.34;  // 20 degrees
    std::array<PlaneFit, 2> planes{first, second};
    const double noise = std::max(near.noise_m, 0.05 * near.spacing_m);
    LineFit line;
    constexpr int kRounds = 12;
    for (int round = 0; round <= kRounds; ++round) {
        const Eigen::Vector3d cross = planes[0].normal.cross(planes[1].normal);
        if (cross.norm() < kLeastSine) return std::nullopt;
        line.direction = cross.normalized();
        Eigen::Matrix3d system;
        system << planes[0].normal.transpose(), planes[1].normal.transpose(), line.direction.transpose();
        const Eigen::Vector3d at(planes[0].normal.dot(planes[0].centre),
                                 planes[1].normal.dot(planes[1].centre), 0);
        line.point = nearestToView(system.inverse() * at, line.direction, near.view);
        const Eigen::Matrix3d inverse = system.inverse();
        const double along = std::max(near.spacing_m, 1e-6);
        const Eigen::Vector3d variance(planes[0].varianceAt(line.point), planes[1].varianceAt(line.point),
                                       along * along / 12);
        line.covariance = inverse * variance.asDiagonal() * inverse.transpose();
        line.inliers = planes[0].inliers + planes[1].inliers;
        line.rms = std::sqrt(0.5 * (planes[0].rms * planes[0].rms + planes[1].rms * planes[1].rms));
        line.slope = std::sqrt(std::max(planes[0].variance[0], planes[1].variance[0])) / cross.norm();
        if (round == kRounds) break;
        for (PlaneFit& plane : planes) {
            const Eigen::Vector3d outwards =
                outwardsOf(near, plane, line.point, line.direction, clear_m, noise);
            const auto side = sideOf(near, plane, line.point, outwards, clear_m, noise);
            const auto fit = refinePlane(side, plane, noise);
            if (!fit) return std::nullopt;
            // It must reach the line near the seed, or the line is none.
            const double reach = clear_m + std::max(0.35 * near.radius_m, 3 * near.spacing_m);
            std::size_t beside = 0;
            for (const FitPoint& each : side)
                if ((each.position - line.point).norm() < reach) ++beside;
            if (beside < 5) return std::nullopt;
            plane = *fit;
        }
    }
    return line;
}

std::optional<LineFit> edgeAtSeed(const Neighbourhood& near) {
    const std::vector<PlaneFit> planes = findPlanes(near, 4);
    const double clear = std::max(1.2 * near.noise_m, 1.5 * near.spacing_m);
    std::optional<LineFit> best;
    std::vector<PlaneFit> bounded;  // by the best edge
    double least = 1;
    const auto consider = [&](const std::optional<LineFit>& line, const std::vector<PlaneFit>& of) {
        if (!line) return;
        const Eigen::Vector3d aside = line->point - near.view.dot(line->point) * near.view;
        const double distance = aside.norm() + 0.3 * std::abs(near.view.dot(line->point));
        // An edge that is not where was clicked is another one.
        if (distance >= 0.3 * near.radius_m) return;
        // Near the line of sight, and of planes that most points lie on.
        double share = 0;
        for (const PlaneFit& plane : of) share += plane.support / static_cast<double>(near.points.size());
        const double cost = distance / near.radius_m - share;
        if (cost >= least) return;
        least = cost;
        best = line;
        bounded = of;
    };
    for (std::size_t i = 0; i < planes.size(); ++i)
        for (std::size_t j = i + 1; j < planes.size(); ++j)
            consider(creaseOf(near, planes[i], planes[j], clear), {planes[i], planes[j]});
    // A crease lies better than a boundary: its planes have all the points.
    if (!best)
        for (const PlaneFit& plane : planes) {
            const auto rough = boundaryOf(near, plane, clear);
            if (!rough) continue;
            // What lies beside the end, the flank of a box, bends a plane that is fitted to all.
            const double noise = std::max(near.noise_m, 0.05 * near.spacing_m);
            const Eigen::Vector3d out = outwardsOf(near, plane, rough->point, rough->direction, clear, noise);
            const auto own = refinePlane(sideOf(near, plane, rough->point, out, clear, noise), plane, noise);
            if (!own) continue;
            consider(boundaryOf(near, *own, clear), {*own});
        }
    if (!best) return best;
    // Beams that pass along the edge see where a surface ends sharper than either.
    for (const PlaneFit& plane : bounded) {
        const auto sharp = silhouetteOf(near, plane, *best);
        const Eigen::Vector3d aside =
            sharp ? Eigen::Vector3d(sharp->point - best->point) : Eigen::Vector3d::Zero();
        if (sharp && aside.norm() < 0.25 * near.radius_m) return sharp;
    }
    return best;
}

}  // namespace vestige
