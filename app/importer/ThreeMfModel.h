#pragma once

#include <cstddef>
#include <span>

#include "core/io/importer/ImporterProtocol.h"

namespace vestige::importer {

/// Sends a 3MF file's meshes and the places where its build items put them. lib3mf says whether the file
/// keeps the specification; it holds coordinates as float, so they, and the transforms, are read from the
/// archive's XML again, in double, and both readings must count the same. Throws ErrorException.
void sendThreeMf(std::span<const std::byte> file, ImportSender& sender);

}  // namespace vestige::importer
