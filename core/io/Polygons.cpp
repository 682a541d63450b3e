#include "core/io/Polygons.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace vestige {
namespace {

constexpr std::size_t kLargestClipped = 64;
/// Clipping takes up to the cube of the corners; a file of many hostile polygons would take hours. No mesh
/// that anyone drew comes near.
constexpr std::size_t kMostClipping = 4000000000;

using Flat = std::vector<Eigen::Vector2d>;

/// The corners in the plane of the polygon's area vector (Newell), counter-clockwise.
Flat flattened(std::span<const std::uint32_t> corners, const PointCloud& vertices) {
    const Eigen::Vector3d first = vertices.point(corners[0]);
    std::vector<Eigen::Vector3d> points;
    for (const std::uint32_t corner : corners) points.emplace_back(vertices.point(corner) - first);
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) area += points[i].cross(points[(i + 1) % points.size()]);
    if (area.norm() == 0) return {};
    const Eigen::Vector3d u = area.unitOrthogonal();
    const Eigen::Vector3d v = area.normalized().cross(u);
    Flat flat;
    for (const Eigen::Vector3d& point : points) flat.emplace_back(point.dot(u), point.dot(v));
    return flat;
}

double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// The corner between its neighbours in `left` is convex and its triangle holds no other corner.
bool isEar(const Flat& flat, const std::vector<std::size_t>& left, std::size_t i) {
    const std::size_t before = left[(i + left.size() - 1) % left.size()];
    const std::size_t after = left[(i + 1) % left.size()];
    const auto& a = flat[before];
    const auto& b = flat[left[i]];
    const auto& c = flat[after];
    if (turn(a, b, c) <= 0) return false;
    for (const std::size_t other : left) {
        if (other == before || other == left[i] || other == after) continue;
        const auto& p = flat[other];
        if (turn(a, b, p) > 0 && turn(b, c, p) > 0 && turn(c, a, p) > 0) return false;
    }
    return true;
}

void fan(std::span<const std::uint32_t> corners, std::vector<Triangle>& triangles) {
    for (std::size_t i = 2; i < corners.size(); ++i)
        triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

}  // namespace

void triangulate(std::span<const std::uint32_t> corners, const PointCloud& vertices,
                 std::vector<Triangle>& triangles) {
    std::vector<std::size_t> left(corners.size());
    for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
    const Flat flat = corners.size() <= kLargestClipped ? flattened(corners, vertices) : Flat{};
    while (!flat.empty() && left.size() > 3) {
        std::size_t ear = 0;
        while (ear < left.size() && !isEar(flat, left, ear)) ++ear;
        if (ear == left.size()) break;
        triangles.push_back({corners[left[(ear + left.size() - 1) % left.size()]], corners[left[ear]],
                             corners[left[(ear + 1) % left.size()]]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    for (std::size_t i = 2; i < left.size(); ++i)
        triangles.push_back({corners[left[0]], corners[left[i - 1]], corners[left[i]]});
}

void Polygons::add(std::span<const std::uint32_t> corners) {
    if (corners.size() < 3) {
        ++skipped_;
    } else if (corners.size() == 3) {
        triangles_.push_back({corners[0], corners[1], corners[2]});
    } else {
        corners_.insert(corners_.end(), corners.begin(), corners.end());
        lengths_.push_back(static_cast<std::uint32_t>(corners.size()));
    }
}

void Polygons::dropBeyond(std::size_t vertices) {
    const auto beyond = [&](const auto& corners) {
        return std::any_of(corners.begin(), corners.end(),
                           [&](std::uint32_t corner) { return corner >= vertices; });
    };
    std::erase_if(triangles_, beyond);
    Polygons kept;
    std::size_t begin = 0;
    for (const std::uint32_t length : lengths_) {
        const auto face = std::span<const std::uint32_t>(corners_).subspan(begin, length);
        if (!beyond(face)) kept.add(face);
        begin += length;
    }
    corners_ = std::move(kept.corners_);
    lengths_ = std::move(kept.lengths_);
}

std::vector<Triangle> Polygons::triangles(const PointCloud& vertices) && {
    std::size_t begin = 0;
    std::size_t clipped = 0;
    for (const std::uint32_t length : lengths_) {
        const auto face = std::span<const std::uint32_t>(corners_).subspan(begin, length);
        begin += length;
        if (length <= kLargestClipped) clipped += std::size_t{length} * length * length;
        if (clipped <= kMostClipping)
            triangulate(face, vertices, triangles_);
        else
            fan(face, triangles_);
    }
    return std::move(triangles_);
}

}  // namespace vestige
