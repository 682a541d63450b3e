#pragma once

#include <filesystem>

#include "core/io/FileFormat.h"

namespace vestige {

/// Writes a cloud as E57, the same bytes for the same input. Scans, poses, sensors, reference system and
/// creation day of an E57 or PTX source are carried on, and its grid, else coordinates are float64. What E57
/// has no place for is told by a message: triangles, the source's pictures, GeoTIFF keys.
Status writeE57(const std::filesystem::path& file, const TriangleMesh& geometry, const WriteOptions& options,
                const JobControl& control);

}  // namespace vestige
