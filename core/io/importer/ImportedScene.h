#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/TriangleMesh.h"
#include "core/io/ReadJob.h"

namespace vestige {

/// One mesh as a foreign reader gives it, in its own frame. Normals and colours are empty or one a vertex.
struct ImportedMesh {
    std::vector<Eigen::Vector3d> vertices;
    std::vector<Eigen::Vector3f> normals;
    std::vector<Color> colors;
    std::vector<Triangle> triangles;
};

/// A mesh at one of its places in the file: x -> linear x + translation.
struct ImportedInstance {
    std::uint32_t mesh = 0;
    Eigen::Affine3d fileFromMesh = Eigen::Affine3d::Identity();
};

/// What a foreign reader found in a file.
struct ImportedScene {
    std::vector<ImportedMesh> meshes;
    std::vector<ImportedInstance> instances;
    std::optional<double> metresPerUnit;
    std::vector<std::string> warnings;
};

/// How many triangles are allowed for a vertex: a closed surface has two (by the formula of Euler).
inline constexpr std::uint64_t kTrianglesOfVertex = 2;

/// Every instance as one geometry, transformed in double; a mirrored one keeps its outside outside. Where
/// only some have colours the others are white, with a warning, and missing normals are zero. Refuses indices
/// without a vertex, places that are no finite numbers, and instances that make more of the file than
/// `mostVertices` or 2^32, or kTrianglesOfVertex times as many triangles.
TriangleMesh assembleScene(ImportedScene scene, std::uint64_t mostVertices, ReadJob& job);

}  // namespace vestige
