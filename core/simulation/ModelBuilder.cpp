#include "core/simulation/ModelBuilder.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace vestige {
namespace {

Eigen::Vector3d anyNormalTo(const Eigen::Vector3d& axis) {
    const Eigen::Vector3d other =
        std::abs(axis.z()) < 0.9 ? Eigen::Vector3d(0, 0, 1) : Eigen::Vector3d(1, 0, 0);
    return axis.cross(other).normalized();
}

}  // namespace

ModelBuilder& ModelBuilder::part(const std::string& name) {
    auto& parts = model_.parts;
    const auto found = std::find(parts.begin(), parts.end(), name);
    part_ = static_cast<std::uint16_t>(found - parts.begin());
    if (found == parts.end()) parts.push_back(name);
    return *this;
}

void ModelBuilder::triangle(const Point& a, const Point& b, const Point& c) {
    if ((b - a).cross(c - a).norm() < 1e-12) return;  // the tip of a cone or the end of a strip
    const auto first = static_cast<std::uint32_t>(model_.vertices.size());
    model_.vertices.insert(model_.vertices.end(), {a, b, c});
    model_.faces.push_back({{first, first + 1, first + 2}, material_, part_});
}

void ModelBuilder::quad(const Point& a, const Point& b, const Point& c, const Point& d) {
    triangle(a, b, c);
    triangle(a, c, d);
}

void ModelBuilder::grid(int rows, int columns, const std::function<Point(int, int)>& at,
                        const std::function<Material(int, int)>& materialAt) {
    const Material before = material_;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            if (materialAt) material_ = materialAt(row, column);
            quad(at(row, column), at(row, column + 1), at(row + 1, column + 1), at(row + 1, column));
        }
    }
    material_ = before;
}

void ModelBuilder::box(const Point& centre, const Point& size) {
    const auto corner = [&](int x, int y, int z) -> Point {
        return centre + 0.5 * size.cwiseProduct(Point(x, y, z));
    };
    quad(corner(-1, -1, -1), corner(-1, 1, -1), corner(1, 1, -1), corner(1, -1, -1));
    quad(corner(-1, -1, 1), corner(1, -1, 1), corner(1, 1, 1), corner(-1, 1, 1));
    quad(corner(-1, -1, -1), corner(1, -1, -1), corner(1, -1, 1), corner(-1, -1, 1));
    quad(corner(-1, 1, -1), corner(-1, 1, 1), corner(1, 1, 1), corner(1, 1, -1));
    quad(corner(-1, -1, -1), corner(-1, -1, 1), corner(-1, 1, 1), corner(-1, 1, -1));
    quad(corner(1, -1, -1), corner(1, 1, -1), corner(1, 1, 1), corner(1, -1, 1));
}

void ModelBuilder::tube(const Point& a, const Point& b, double radiusA, double radiusB, int segments) {
    const double length = (b - a).norm();
    const Point axis = (b - a) / length;
    lathe(a, axis, anyNormalTo(axis), {{0, 0}, {radiusA, 0}, {radiusB, length}, {0, length}}, segments);
}

void ModelBuilder::lathe(const Point& centre, const Point& axis, const Point& reference,
                         const std::vector<std::pair<double, double>>& profile, int segments) {
    const Point aside = axis.cross(reference);
    const auto at = [&](int row, int column) -> Point {
        const double angle = 2 * std::numbers::pi * (column % segments) / segments;
        double cosine = std::cos(angle);
        double sine = std::sin(angle);
        // sin(pi) is not zero in floating point; features on these vertices are meant to be exact.
        if (4 * column % (2 * segments) == 0) sine = 0;
        if (4 * column % (2 * segments) == segments) cosine = 0;
        const auto& [radius, height] = profile[static_cast<std::size_t>(row)];
        return centre + height * axis + radius * (cosine * reference + sine * aside);
    };
    grid(static_cast<int>(profile.size()) - 1, segments, at);
}

void ModelBuilder::feature(const std::string& name, const Point& position, const Point& lookFrom,
                           const std::string& snap) {
    model_.features.push_back({name, position, part_, lookFrom.normalized(), snap});
}

}  // namespace vestige
