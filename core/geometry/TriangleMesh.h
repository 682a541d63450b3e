#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/geometry/PointCloud.h"

namespace vestige {

using Triangle = std::array<std::uint32_t, 3>;

/// A surface of triangles over the points of a cloud. Without triangles it is just that cloud; readers,
/// layers and the view hold every geometry this way.
struct TriangleMesh {
    PointCloud vertices;
    std::vector<Triangle> triangles;

    bool isMesh() const { return !triangles.empty(); }
    TriangleMesh transformed(const Similarity& toFromHere) const& {
        return {vertices.transformed(toFromHere), triangles};
    }
    TriangleMesh transformed(const Similarity& toFromHere) && {
        return {std::move(vertices).transformed(toFromHere), std::move(triangles)};
    }
};

/// Area in squared units of the mesh.
double surfaceArea(const TriangleMesh& mesh);

/// Points spread over the surface with the given mean spacing (same unit as the mesh), at random but the same
/// for the same seed; each carries its triangle's normal. The vertices themselves when there are no
/// triangles.
PointCloud sampleSurface(const TriangleMesh& mesh, double spacing, std::uint64_t seed = 1);

}  // namespace vestige
