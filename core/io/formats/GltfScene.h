#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/BoundingBox.h"
#include "core/io/formats/GltfJson.h"
#include "core/io/importer/ImportedScene.h"

namespace vestige {

/// One primitive of a glTF mesh that is read: triangles, or points where it has none.
struct GltfPrimitive {
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;
    bool normals = false;
    bool colors = false;
    std::optional<BoundingBox> bounds;  ///< in its own frame, as the document says
};

/// A glTF 2.0 scene without its bytes. World coordinates are Vestige's, z up: glTF's (x, y, z) is (x, -z, y).
struct GltfScene {
    std::string document;                ///< only the primitives: one mesh and node for each, in order
    std::vector<std::uint64_t> buffers;  ///< of the source's buffers, those of `document`
    std::vector<GltfPrimitive> primitives;
    std::vector<ImportedInstance> instances;  ///< ImportedInstance::mesh counts the primitives
    std::uint64_t bytes = 0;                  ///< of all primitives' items, each primitive for itself
    std::string generator;
};

/// Checks a document and takes its geometry out of it: nodes in double, no node twice (so no cycles), every
/// accessor inside its buffer. Refuses required extensions, each by its name; warns of what is passed over.
GltfScene readGltfScene(const nlohmann::json& document, ReadJob& job);

}  // namespace vestige
