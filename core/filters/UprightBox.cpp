#include "core/filters/UprightBox.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace vestige {
namespace {

double cross(const Eigen::Vector2d& o, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return (a - o).x() * (b - o).y() - (a - o).y() * (b - o).x();
}

/// Convex hull, counterclockwise (Andrew's monotone chain).
std::vector<Eigen::Vector2d> hullOf(std::vector<Eigen::Vector2d> points) {
    std::sort(points.begin(), points.end(),
              [](const auto& a, const auto& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) return points;
    std::vector<Eigen::Vector2d> hull;
    const auto add = [&hull](const Eigen::Vector2d& point, std::size_t fewest) {
        while (hull.size() >= fewest && cross(hull[hull.size() - 2], hull.back(), point) <= 0)
            hull.pop_back();
        hull.push_back(point);
    };
    for (const Eigen::Vector2d& point : points) add(point, 2);
    const std::size_t lower = hull.size() + 1;
    for (auto point = points.rbegin() + 1; point != points.rend(); ++point) add(*point, lower);
    hull.pop_back();
    return hull;
}

}  // namespace

UprightBox uprightBox(std::span<const Eigen::Vector3f> points) {
    UprightBox box;
    if (points.empty()) return box;
    std::vector<Eigen::Vector2d> plan;
    plan.reserve(points.size());
    float low = points.front().z();
    float high = low;
    for (const Eigen::Vector3f& point : points) {
        plan.emplace_back(point.head<2>().cast<double>());
        low = std::min(low, point.z());
        high = std::max(high, point.z());
    }
    box.bottom_m = low;
    box.height_m = static_cast<double>(high) - static_cast<double>(low);
    const std::vector<Eigen::Vector2d> hull = hullOf(std::move(plan));
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Eigen::Vector2d side = hull[(i + 1) % hull.size()] - hull[i];
        if (!(side.norm() > 0)) continue;
        const Eigen::Vector2d along = side.normalized();
        const Eigen::Vector2d across(-along.y(), along.x());
        double first = std::numeric_limits<double>::infinity(), last = -first, farthest = 0;
        for (const Eigen::Vector2d& corner : hull) {
            first = std::min(first, along.dot(corner));
            last = std::max(last, along.dot(corner));
            farthest = std::max(farthest, across.dot(corner - hull[i]));
        }
        const double area = (last - first) * farthest;
        if (area >= least) continue;
        least = area;
        box.length_m = std::max(last - first, farthest);
        box.width_m = std::min(last - first, farthest);
    }
    return box;
}

}  // namespace vestige
