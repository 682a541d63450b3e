#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/measurement/kinds/KindInput.h"

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

Result<KindValues> boxValues(const KindInput& input) {
    std::vector<Point> plan;
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (const KindEnd& end : input.ends) {
        plan.emplace_back((end.position - input.at(0)).head<2>());
        lowest = std::min(lowest, end.position.z());
        highest = std::max(highest, end.position.z());
    }
    const std::vector<Point> hull = hullOf(plan);
    if (hull.size() < 3) return fail(ErrorCode::input, "the points of the box lie on one line in plan");
    // The smallest rectangle has a side along one of the hull's.
    double best = std::numeric_limits<double>::infinity();
    Eigen::Vector2d sides = Eigen::Vector2d::Zero();
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
        const Eigen::Vector2d extent = high - low;
        if (extent.prod() >= best) continue;
        best = extent.prod();
        sides = extent;
    }
    const double length = sides.maxCoeff(), width = sides.minCoeff(), height = highest - lowest;
    return KindValues{{{"length", "Length of the box", QuantityUnit::metre, length},
                       {"width", "Width of the box", QuantityUnit::metre, width},
                       {"height", "Height of the box", QuantityUnit::metre, height},
                       {"diagonal", "Diagonal of the box", QuantityUnit::metre,
                        std::sqrt(length * length + width * width + height * height)},
                       {"volume", "Volume of the box", QuantityUnit::cubicMetre, length * width * height}}};
}

}  // namespace vestige
