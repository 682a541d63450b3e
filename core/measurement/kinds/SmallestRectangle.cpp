#include "core/measurement/kinds/SmallestRectangle.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace vestige {
namespace {

using Point = Eigen::Vector2d;

double turn(const Point& a, const Point& b, const Point& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Convex hull, counter-clockwise (Andrew's monotone chain).
std::vector<Point> hullOf(std::vector<Point> points) {
    std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) {
        return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
    });
    std::vector<Point> hull;
    for (int pass = 0; pass < 2; ++pass) {
        const std::size_t kept = hull.size();
        for (const Point& point : points) {
            while (hull.size() >= kept + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0)
                hull.pop_back();
            hull.push_back(point);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

}  // namespace

std::optional<std::array<Eigen::Vector2d, 4>> smallestRectangle(std::span<const Eigen::Vector2d> points) {
    const std::vector<Point> hull = hullOf({points.begin(), points.end()});
    if (hull.size() < 3) return std::nullopt;
    double best = std::numeric_limits<double>::infinity();
    std::array<Eigen::Vector2d, 4> corners;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Point along = (hull[(i + 1) % hull.size()] - hull[i]).normalized();
        const Point across(-along.y(), along.x());
        Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
        Eigen::Vector2d high = -low;
        for (const Point& point : hull) {
            const Eigen::Vector2d placed(along.dot(point), across.dot(point));
            low = low.cwiseMin(placed);
            high = high.cwiseMax(placed);
        }
        if ((high - low).prod() >= best) continue;
        best = (high - low).prod();
        corners = {low.x() * along + low.y() * across, high.x() * along + low.y() * across,
                   high.x() * along + high.y() * across, low.x() * along + high.y() * across};
    }
    return corners;
}

}  // namespace vestige
