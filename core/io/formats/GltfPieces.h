#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/geometry/TriangleMesh.h"

namespace vestige {

/// A part of a geometry whose points are near enough to one origin that float offsets hold them.
struct GltfPiece {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< whole units
    bool everything = false;                           ///< all points in order, `points` is empty
    std::vector<std::uint32_t> points;                 ///< of the cloud
    std::vector<Triangle> triangles;                   ///< of this piece's points; unused where `everything`
};

/// One piece where every coordinate is within 1024 of the middle, which float offsets hold to 0.03 mm (of
/// metres); else a piece for each cell of 1024 units that holds points, in the order of their first points. A
/// triangle belongs to the cell of its first corner, where corners from other cells are repeated.
std::vector<GltfPiece> gltfPieces(const TriangleMesh& mesh);

}  // namespace vestige
