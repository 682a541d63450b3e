#pragma once

#include <string>

#include "core/io/importer/ImporterProtocol.h"

namespace vestige::importer {

/// Reads the meshes of a glTF 2.0 document with Assimp and sends them, one for each node of its scene, in
/// order. `request` is JSON: {"document": the text of a document whose buffers are named "0", "1", ...,
/// "buffers": [{"file": descriptor, "offset", "length"}]}. Throws ErrorException.
void sendGltf(const std::string& request, ImportSender& sender);

}  // namespace vestige::importer
