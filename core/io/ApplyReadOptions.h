#pragma once

#include "core/io/FileFormat.h"
#include "core/io/ReadOptions.h"

namespace vestige {

/// Does to a whole file's geometry what a reader that heeds the options would have done while reading:
/// attributes, box, every k-th point. Counts, bounds and attributes in the info follow. A reader that did it
/// itself says so in LoadedGeometry::heeded and is left alone.
void applyReadOptions(const ReadOptions& options, LoadedGeometry& loaded);

}  // namespace vestige
