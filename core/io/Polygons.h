#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/TriangleMesh.h"

namespace vestige {

/// Collects the faces of a mesh file and cuts those with more than three corners into triangles once the
/// vertices are known.
class Polygons {
  public:
    /// Indices of the face's corners in order; fewer than three corners are no face and are counted apart.
    void add(std::span<const std::uint32_t> corners);
    std::size_t skipped() const { return skipped_; }
    std::size_t faces() const { return triangles_.size() + lengths_.size() + skipped_; }

    /// Forgets the faces that name a vertex from `vertices` on, as those of a file that ends early may.
    void dropBeyond(std::size_t vertices);

    /// The triangles, those of three-cornered faces first. Every index must be below `vertices.size()`.
    std::vector<Triangle> triangles(const PointCloud& vertices) &&;

  private:
    std::vector<Triangle> triangles_;
    std::vector<std::uint32_t> corners_;  // of larger faces, one after the other
    std::vector<std::uint32_t> lengths_;  // of those faces
    std::size_t skipped_ = 0;
};

/// Cuts ears off a simple polygon, also a concave one; polygons that are not simple, and those with more than
/// 64 corners, become a fan.
void triangulate(std::span<const std::uint32_t> corners, const PointCloud& vertices,
                 std::vector<Triangle>& triangles);

}  // namespace vestige
