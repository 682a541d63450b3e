#include "core/measurement/fit/CircleFit.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/measurement/fit/PlaneFit.h"

namespace vestige {
namespace {

constexpr std::size_t kSectors = 24;
/// More points than these no longer make a circle better than its own roundness, but a click slower.
constexpr std::size_t kMostPoints = 12000;

struct Ring {
    Eigen::Vector3d parameters = Eigen::Vector3d::Zero();  ///< centre x, y, radius
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    double rms = 0;
    std::size_t inliers = 0;
    double turn = 0;  ///< share of the turn that has points
};

/// Kåsa's linear fit, weighted: x^2 + y^2 = 2ax + 2by + c.
std::optional<Eigen::Vector3d> algebraic(const std::vector<Eigen::Vector2d>& points,
                                         const std::vector<double>& weights) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector3d row(2 * points[i].x(), 2 * points[i].y(), 1);
        normal += weights[i] * row * row.transpose();
        right += weights[i] * points[i].squaredNorm() * row;
    }
    const Eigen::FullPivLU<Eigen::Matrix3d> solver(normal);
    if (!solver.isInvertible()) return std::nullopt;
    const Eigen::Vector3d found = solver.solve(right);
    const double squared = found[2] + found.head<2>().squaredNorm();
    if (!(squared > 0)) return std::nullopt;
    return Eigen::Vector3d(found[0], found[1], std::sqrt(squared));
}

double turnOf(const std::vector<Eigen::Vector2d>& points, const std::vector<double>& weights,
              const Eigen::Vector3d& circle) {
    std::array<double, kSectors> filled{};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector2d from = points[i] - circle.head<2>();
        const double angle = std::atan2(from.y(), from.x()) / (2 * std::numbers::pi) + 0.5;
        filled[std::min(kSectors - 1, static_cast<std::size_t>(angle * kSectors))] += weights[i];
    }
    return static_cast<double>(
               std::count_if(filled.begin(), filled.end(), [](double w) { return w > 0.5; })) /
           kSectors;
}

/// Geometric fit by Gauss-Newton from `start`, residuals judged by `scale`.
std::optional<Ring> refined(const std::vector<Eigen::Vector2d>& points, const Eigen::Vector3d& start,
                            double scale) {
    Ring ring;
    ring.parameters = start;
    std::vector<double> weights(points.size());
    for (int round = 0; round < 30; ++round) {
        Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
        Eigen::Vector3d right = Eigen::Vector3d::Zero();
        double sum = 0;
        double squares = 0;
        ring.inliers = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Eigen::Vector2d from = points[i] - ring.parameters.head<2>();
            const double distance = from.norm();
            if (distance <= 0) continue;
            const double residual = distance - ring.parameters[2];
            weights[i] = tukeyWeight(residual, scale);
            if (weights[i] <= 0) continue;
            const Eigen::Vector3d row(from.x() / distance, from.y() / distance, 1);
            normal += weights[i] * row * row.transpose();
            right += weights[i] * residual * row;
            sum += weights[i];
            squares += weights[i] * residual * residual;
            ++ring.inliers;
        }
        if (ring.inliers < 12) return std::nullopt;
        const Eigen::LDLT<Eigen::Matrix3d> solver(normal);
        const Eigen::Vector3d step = solver.solve(right);
        if (solver.info() != Eigen::Success || !step.allFinite()) return std::nullopt;
        ring.parameters += step;
        if (!(ring.parameters[2] > 0)) return std::nullopt;
        ring.rms = std::sqrt(squares / sum);
        const double variance = squares / std::max(1.0, sum - 3);
        ring.covariance = variance * solver.solve(Eigen::Matrix3d::Identity());
        if (step.norm() < 1e-9) break;
    }
    ring.turn = turnOf(points, weights, ring.parameters);
    return ring;
}

/// Where the points end outwards from `centre`, in each sector: the farthest of those that have others near
/// them.
std::vector<Eigen::Vector2d> outline(const std::vector<Eigen::Vector2d>& points,
                                     const Eigen::Vector2d& centre, double thin) {
    constexpr std::size_t kFine = 3 * kSectors;
    std::array<std::vector<double>, kFine> distances;
    for (const Eigen::Vector2d& point : points) {
        const Eigen::Vector2d from = point - centre;
        const double angle = std::atan2(from.y(), from.x()) / (2 * std::numbers::pi) + 0.5;
        distances[std::min(kFine - 1, static_cast<std::size_t>(angle * kFine))].push_back(from.norm());
    }
    std::vector<Eigen::Vector2d> ends;
    for (std::size_t k = 0; k < kFine; ++k) {
        auto& here = distances[k];
        if (here.size() < 3) continue;
        std::sort(here.begin(), here.end());
        std::size_t last = here.size() - 1;
        while (last > 0 && here[last] - here[last - 1] > thin) --last;
        const double angle = 2 * std::numbers::pi * ((static_cast<double>(k) + 0.5) / kFine - 0.5);
        ends.emplace_back(centre + here[last] * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    return ends;
}

/// The ring that fits best among starts from all points, thirds left out in turn.
std::optional<Ring> bestRing(const std::vector<Eigen::Vector2d>& points, double scale) {
    std::optional<Ring> best;
    for (int leave = -1; leave < 4; ++leave) {
        std::vector<double> weights(points.size(), 1);
        for (std::size_t i = 0; i < points.size(); ++i)
            if (leave >= 0 && (points[i].x() > 0) + 2 * (points[i].y() > 0) == leave) weights[i] = 0;
        const auto start = algebraic(points, weights);
        if (!start) continue;
        auto ring = refined(points, *start, 4 * scale);
        if (ring) ring = refined(points, ring->parameters, scale);
        if (!ring || ring->turn < 0.3) continue;
        if (!best || ring->inliers * ring->turn > best->inliers * best->turn) best = ring;
    }
    return best;
}

/// Every k-th of the points, where they are many.
Neighbourhood thinned(const Neighbourhood& near) {
    const std::size_t step = (near.points.size() + kMostPoints - 1) / kMostPoints;
    if (step <= 1) return near;
    Neighbourhood part = near;
    part.points.clear();
    for (std::size_t i = 0; i < near.points.size(); i += step) part.points.push_back(near.points[i]);
    part.spacing_m *= std::sqrt(static_cast<double>(step));
    return part;
}

}  // namespace

std::optional<CircleFit> circleAtSeed(const Neighbourhood& all) {
    const Neighbourhood near = thinned(all);
    const auto plane = planeAtSeed(near);
    if (!plane) return std::nullopt;
    const double noise = std::max(near.noise_m, 0.05 * near.spacing_m);
    std::vector<Eigen::Vector2d> points;
    for (const FitPoint& point : near.points) {
        if (std::abs(plane->distance(point.position)) > 3 * noise) continue;
        const Eigen::Vector3d from = point.position - plane->centre;
        points.emplace_back(plane->axes.col(0).dot(from), plane->axes.col(1).dot(from));
    }
    if (points.size() < 20) return std::nullopt;
    const double scale = std::max(noise, near.spacing_m);
    auto ring = bestRing(points, scale);
    const auto share = [&](const Ring& of) {
        return static_cast<double>(of.inliers) / static_cast<double>(points.size());
    };
    if (!ring || share(*ring) < 0.6) {
        // No ring: a disc, whose rim is where its points end.
        Eigen::Vector2d middle = Eigen::Vector2d::Zero();
        for (const Eigen::Vector2d& point : points) middle += point / static_cast<double>(points.size());
        for (int round = 0; round < 3; ++round) {
            const auto ends = outline(points, middle, 4 * scale);
            ring = bestRing(ends, scale);
            if (!ring) return std::nullopt;
            middle = ring->parameters.head<2>();
        }
        // The outline must close: its ends lie on it, and it lies within the neighbourhood.
        if (ring->turn < 0.6 || ring->parameters[2] > 0.85 * near.radius_m) return std::nullopt;
    }
    CircleFit circle;
    circle.axis = plane->normal;
    circle.radius = ring->parameters[2];
    circle.centre =
        plane->centre + ring->parameters[0] * plane->axes.col(0) + ring->parameters[1] * plane->axes.col(1);
    const Eigen::Matrix<double, 3, 2> inPlane = plane->axes.leftCols<2>();
    circle.covariance = inPlane * ring->covariance.topLeftCorner<2, 2>() * inPlane.transpose() +
                        plane->varianceAt(circle.centre) * plane->normal * plane->normal.transpose();
    circle.radiusUncertainty = std::sqrt(ring->covariance(2, 2));
    circle.axisUncertainty = std::sqrt(std::max(plane->variance[0], plane->variance[1]));
    circle.rms = ring->rms;
    circle.inliers = ring->inliers;
    return circle;
}

}  // namespace vestige
