#pragma once

#include "core/io/FileFormat.h"
#include "core/io/ReadJob.h"

namespace vestige {

/// Fills what the points themselves say: counts, bounds, attributes, time span.
void describeGeometry(const TriangleMesh& geometry, FileInfo& info);

/// A reader's result: the geometry described, under the format's name, with the job's warnings.
LoadedGeometry loaded(TriangleMesh geometry, std::string format, std::string version, ReadJob& job);

}  // namespace vestige
