#pragma once

#include "core/io/FileFormat.h"

namespace vestige {

/// Writes glTF 2.0: binary, or with the extension .gltf as text with the bytes inside. Points are a primitive
/// of mode POINTS, meshes one of triangles; normals and colours go along. Positions are float offsets from
/// the double translation of their node, below a node that turns z up into glTF's y up, so that the world
/// coordinates come back to 0.03 mm. ErrorCode::output on failure, also where more than 4 GiB were needed.
Status writeGltf(const std::filesystem::path& file, const TriangleMesh& geometry, const WriteOptions& options,
                 const JobControl& control);

}  // namespace vestige
