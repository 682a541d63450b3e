#pragma once

#include "core/geometry/Pose.h"
#include "core/io/FileFormat.h"

namespace vestige {

/// What a file said of itself, once its points were moved by `metresFromFile` into a frame in metres: where
/// its scanners and cameras stood moves along, its grid grows with the unit, and its reference system, which
/// described the file's own coordinates, is dropped.
void moveIntoMetres(FileInfo& info, const Similarity& metresFromFile);

/// The points, too.
void moveIntoMetres(LoadedGeometry& loaded, const Similarity& metresFromFile);

}  // namespace vestige
