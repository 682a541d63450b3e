#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/io/formats/GltfJson.h"

namespace vestige {

/// A mesh of a glTF document at one of its places, in Vestige's axes (z up).
struct GltfMeshPlace {
    std::uint64_t mesh = 0;
    Eigen::Affine3d worldFromMesh = Eigen::Affine3d::Identity();
};

/// The meshes of the default scene (else the first one, else of all nodes, else each mesh once). Node
/// matrices are multiplied in double. Refuses a node that is reached twice.
std::vector<GltfMeshPlace> walkGltfNodes(const GltfJson& document);

}  // namespace vestige
